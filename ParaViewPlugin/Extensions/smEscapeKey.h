/**
 * @file smEscapeKey.h
 * @brief Detects the key Esc in a window of this process while its event loop does not run
 *
 * X11 only. The window is the one with the keyboard focus (or, where no window manager sets a focus, the one
 * below the pointer), or the nearest one around it, whose property _NET_WM_PID names this process; Qt sets
 * that property, VTK's own windows do not have it. The key is grabbed for that window during the life of the
 * object, over a connection of its own: a key press between two calls of WasPressed() is not lost, and the
 * application's own event queue is not touched.
 */
#ifndef smEscapeKey_h
#define smEscapeKey_h

#include <memory> // for std::unique_ptr

struct xcb_connection_t;

namespace sm
{
class EscapeKey
{
public:
  /** Null without an X display, or when no window of this process has the focus. Takes about a millisecond
   * and reports no errors. */
  static std::unique_ptr<EscapeKey> Listen();
  ~EscapeKey();

  /** True once Esc was pressed after Listen(). Does not block. */
  bool WasPressed();

private:
  explicit EscapeKey(xcb_connection_t* connection);
  EscapeKey(const EscapeKey&) = delete;
  void operator=(const EscapeKey&) = delete;

  xcb_connection_t* Connection;
  bool Pressed = false;
};
}

#endif
