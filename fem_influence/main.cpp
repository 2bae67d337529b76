#include "bem_contact/base/body_file.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "fem_influence/parallel.hpp"
#include "fem_influence/run.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <mpi.h>

#include <cstdio>
