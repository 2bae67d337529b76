#pragma once

namespace bem_contact::fatigue {

/// p0 / k up to which steel that has flowed below the surface stays elastic afterwards, where friction uses
/// `traction` (shear over normal force). Of a long contact, that is a Hertz line contact that slips all over:
/// residual stresses cancel all but the shear along the surface, so that this shear must not exceed k
/// anywhere (Melan's theorem; Johnson, Contact Mechanics (1985), section 9.2; stresses: McEwen 1949, there
/// eqs. 4.49 and 7.8). The steel is elastic and perfectly plastic. 4 without friction; never above the limit
/// of the surface, 1 / traction, and equal to it from 0.367 on. A patch as wide as it is long bears up to a
/// sixth more (Ponter, Hearle and Johnson, J. Mech. Phys. Solids 33 (1985) 339).
double limit_below(double traction);

} // namespace bem_contact::fatigue
