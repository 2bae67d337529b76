#pragma once

namespace bem_contact {

/// Does what in_parts() does, for a body that is given by its address and a function that calls it.
void call_in_parts(int threads, int count, const void* body,
                   void (*call)(const void* body, int first, int end, int part));

/// Divides 0 .. count - 1 into at most `threads` runs of about equal length and calls body(first, end, part)
/// for each, `part` its number from 0 on, side by side on as many threads (OpenMP). With one thread the body
/// runs here. What one of them throws is thrown here when all have ended.
template <class Body> void in_parts(int threads, int count, const Body& body) {
  if (threads <= 1)
    body(0, count, 0);
  else
    call_in_parts(threads, count, &body, [](const void* called, int first, int end, int part) {
      (*static_cast<const Body*>(called))(first, end, part);
    });
}

} // namespace bem_contact
