#include "bem_contact/report/report_page.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/report/report_data.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <ostream>

// embedded.S; each ends with a NUL.
extern "C" {
extern const char report_page_html[], report_page_css[], report_page_js[], report_contact_figures_js[],
    report_curve_figures_js[], report_words_js[], report_plotting_library[];
}

namespace bem_contact::report {

namespace {

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
}

} // namespace

std::string report_page(const nlohmann::json& data) {
  if (*report_plotting_library == '\0')
    throw InputError("This build draws no reports",
                     "the Debian package python3-plotly was missing when it was built",
                     "Run tools/install_packages contact-only, configure again (cmake --fresh) and build.");
  std::string text = data.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  replace_all(text, "</", "<\\/"); // no text of a scene ends the script that holds it
  replace_all(text, "<!--", "<\\u0021--");
  std::string page = report_page_html;
  const std::array<std::pair<std::string, std::string>, 4> parts{
      {{"@STYLE@", report_page_css},
       {"@SCRIPT@",
        std::string(report_contact_figures_js) + report_curve_figures_js + report_words_js + report_page_js},
       {"@LIBRARY@", report_plotting_library},
       {"@DATA@", text}}};
  for (const auto& [name, part] : parts)
    page.replace(page.find(name), name.size(), part);
  return page;
}

void write_report(const std::filesystem::path& file, const std::filesystem::path& output) {
  require_outputs({file}, {{.option = "--output", .file = output, .required = true}});
  const std::string page = report_page(report_data(file));
  write_text(output, [&](std::ostream& out) { out << page; });
}

} // namespace bem_contact::report
