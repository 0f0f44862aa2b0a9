#include "number/versions.hpp"

#include <CGAL/version.h>
#include <gmp.h>
#include <mpfi.h>
#include <mpfr.h>

#include <boost/version.hpp>

namespace lamina::number {

std::vector<std::pair<std::string, std::string>> library_versions() {
  return {{"boost", BOOST_LIB_VERSION},
          {"cgal", CGAL_STR(CGAL_VERSION)},
          {"gmp", gmp_version},
          {"mpfr", mpfr_get_version()},
          {"mpfi", mpfi_get_version()}};
}

}  // namespace lamina::number
