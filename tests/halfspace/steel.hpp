#pragma once

#include "bem_contact/base/material.hpp"

inline const bem_contact::Material steel{82000, 0.28};
