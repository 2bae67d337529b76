#pragma once

/// words.json: how pages and pictures call names, what each kind of answer shows, and the first numbers of a
/// study. It is part of the program (embedded.S), and ends with a NUL.
extern "C" const char record_words_json[];
