#include "bem_contact/base/ending_signals.hpp"

#include "bem_contact/base/error.hpp"

#include <windows.h>

namespace bem_contact {

namespace {

HANDLE came = nullptr; ///< an event: a handler knows nothing else of the object

BOOL WINAPI note_end(DWORD) {
  SetEvent(came);
  return TRUE;
}

} // namespace

struct EndingSignals::Before {};

EndingSignals::EndingSignals() {
  came = CreateEventW(nullptr, TRUE, FALSE, nullptr);
  if (!came)
    throw Error("The page cannot be served", "the system opens no more files", "Close other programs.");
  SetConsoleCtrlHandler(nullptr, FALSE); // a shell may have told its children to ignore Ctrl-C
  SetConsoleCtrlHandler(note_end, TRUE);
}

EndingSignals::~EndingSignals() {
  SetConsoleCtrlHandler(note_end, FALSE);
  CloseHandle(came);
}

void EndingSignals::wait() const {
  WaitForSingleObject(came, INFINITE);
}

} // namespace bem_contact
