/**
 * @file smEscapeKey.h
 * @brief Hears the key Esc in a window of this process while its event loop does not run
 *
 * On X11, where the window with the keyboard's focus (or, where no window manager gives it to one, that below the pointer)
 * belongs to this process, as its _NET_WM_PID says; Qt sets that, VTK's own windows have none. The key is grabbed for
 * that window as long as the object lives, over a connection of its own: a tap between two questions is not lost, and the
 * application's own event queue is left alone.
 */
#ifndef smEscapeKey_h
#define smEscapeKey_h

#include <memory> // for the connection

namespace sm
{
class EscapeKey
{
public:
  /** Null where there is no X display, or no window of this process has the focus; never blocks for long and never fails loudly. */
  static std::unique_ptr<EscapeKey> Listen();
  ~EscapeKey();

  /** Whether Esc went down since the object was made; once it did, always. Does not block. */
  bool WasPressed();

private:
  struct Internals;
  explicit EscapeKey(std::unique_ptr<Internals> implementation);
  EscapeKey(const EscapeKey&) = delete;
  void operator=(const EscapeKey&) = delete;

  std::unique_ptr<Internals> Implementation;
};
}

#endif
