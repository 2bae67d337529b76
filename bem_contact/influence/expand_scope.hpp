#pragma once

/// Private to this room: what the checked options of expand() come to.
namespace bem_contact {

struct StationRange {
  int first = 0, count = 0;
};

/// Element length on the reference radius and the load's scale: A(x; a) = (Rc/R) A_ref(x R/Rc; a R/Rc), since
/// the kernel's unit load is per reference area.
struct Scaling {
  double dx = 0, load = 1;
};

} // namespace bem_contact
