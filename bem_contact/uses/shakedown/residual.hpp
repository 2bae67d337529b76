#pragma once

namespace bem_contact::shakedown {

/// Which residual stresses are taken into account.
enum class Residual {
  all,     ///< every field that balances itself and does not vary along x
  in_plane ///< without the shears xs and xn: where traction changes its direction, they do not build up
};

} // namespace bem_contact::shakedown
