#pragma once

namespace bem_contact {

/// Programs call it when they start: memory that is freed stays with the process, up to 256 MB. Each case of
/// a sequence needs what the one before has freed; given back and fetched again it costs a tenth of the time,
/// because the system clears every page. A library leaves this choice to its program.
void keep_freed_memory();

} // namespace bem_contact
