#pragma once

namespace bem_contact {

/// Programs call it when they start: memory that is freed stays with the process, up to 512 MB, and the first
/// 256 MB come in large pages. Each case of a sequence needs what the one before has freed; given back and
/// fetched again it costs a tenth of the time, because the system clears every page. Large pages take a third of
/// the time of a first answer on 10,000 elements (tools/BENCHMARKS.md, section 10). A library leaves this choice to
/// its program.
void keep_freed_memory();

} // namespace bem_contact
