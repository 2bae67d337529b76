#pragma once

namespace bem_contact {

/// Sends what is said of profiles to Python's logging (bem_contact/messages.py).
void send_messages_to_logging();

} // namespace bem_contact
