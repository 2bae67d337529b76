/* The standard library of mingw-w64 makes names of files of std::string by this function, and in the locale
 * "C" each byte would be a letter. Ours reads UTF-8, as path::string() writes it; the linker puts it in the
 * place of the other one (--wrap). Letters that take four bytes are refused. */
#include <errno.h>
#include <stddef.h>
#include <wchar.h>

static size_t refuse(void) {
  errno = EILSEQ;
  return (size_t)-1;
}

size_t __wrap_mbrtowc(wchar_t* to, const char* from, size_t size, mbstate_t* state) {
  (void)state;
  if (!from)
    return 0;
  if (size == 0)
    return (size_t)-2;
  const unsigned char* bytes = (const unsigned char*)from;
  const unsigned first = bytes[0];
  const size_t length = first < 0x80                    ? 1
                        : first >= 0xc2 && first < 0xe0 ? 2
                        : first >= 0xe0 && first < 0xf0 ? 3
                                                        : 0;
  if (length == 0)
    return refuse();
  if (size < length)
    return (size_t)-2;
  unsigned letter = length == 1 ? first : first & (0xffu >> (length + 1));
  for (size_t i = 1; i < length; ++i) {
    if ((bytes[i] & 0xc0) != 0x80)
      return refuse();
    letter = letter << 6 | (bytes[i] & 0x3fu);
  }
  if (to)
    *to = (wchar_t)letter;
  return letter == 0 ? 0 : length;
}
