#include "smEscapeKey.h"

#ifdef SOLIDMOMENTS_HAS_XCB

#include <unistd.h>
#include <xcb/xcb.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

namespace sm
{
namespace
{
/// XK_Escape of X's keysymdef.h.
constexpr xcb_keysym_t EscapeSymbol = 0xff1b;

constexpr xcb_window_t NoWindow = XCB_WINDOW_NONE;

/// Owns a reply of xcb, which is allocated by malloc.
template <typename T>
std::unique_ptr<T, decltype(&std::free)> Own(T* reply)
{
  return { reply, &std::free };
}

bool IsOfThisProcess(xcb_connection_t* connection, xcb_window_t window, xcb_atom_t pidAtom)
{
  const auto property = Own(xcb_get_property_reply(
    connection, xcb_get_property(connection, 0, window, pidAtom, XCB_ATOM_CARDINAL, 0, 1), nullptr));
  if (!property || property->format != 32 || xcb_get_property_value_length(property.get()) != 4)
  {
    return false;
  }
  std::uint32_t pid = 0;
  std::memcpy(&pid, xcb_get_property_value(property.get()), sizeof(pid));
  return pid == static_cast<std::uint32_t>(getpid());
}

xcb_window_t GetActiveWindow(xcb_connection_t* connection, xcb_window_t root)
{
  const auto focus = Own(xcb_get_input_focus_reply(connection, xcb_get_input_focus(connection), nullptr));
  if (focus && focus->focus > XCB_INPUT_FOCUS_POINTER_ROOT && focus->focus != root)
  {
    return focus->focus;
  }
  const auto pointer = Own(xcb_query_pointer_reply(connection, xcb_query_pointer(connection, root), nullptr));
  return pointer ? pointer->child : NoWindow;
}

/// The active window or the nearest window around it that belongs to this process.
xcb_window_t FindOwnWindow(xcb_connection_t* connection, xcb_window_t root)
{
  static const char name[] = "_NET_WM_PID";
  const auto atom =
    Own(xcb_intern_atom_reply(connection, xcb_intern_atom(connection, 1, sizeof(name) - 1, name), nullptr));
  xcb_window_t window = atom ? GetActiveWindow(connection, root) : NoWindow;
  while (window != NoWindow && window != root && !IsOfThisProcess(connection, window, atom->atom))
  {
    const auto tree = Own(xcb_query_tree_reply(connection, xcb_query_tree(connection, window), nullptr));
    window = tree ? tree->parent : NoWindow;
  }
  return window == root ? NoWindow : window;
}

std::vector<xcb_keycode_t> FindKeys(xcb_connection_t* connection)
{
  const xcb_setup_t* setup = xcb_get_setup(connection);
  const int count = setup->max_keycode - setup->min_keycode + 1;
  const auto mapping = Own(xcb_get_keyboard_mapping_reply(connection,
    xcb_get_keyboard_mapping(connection, setup->min_keycode, static_cast<std::uint8_t>(count)), nullptr));
  std::vector<xcb_keycode_t> keys;
  const int width = mapping ? mapping->keysyms_per_keycode : 0;
  const xcb_keysym_t* symbols = mapping ? xcb_get_keyboard_mapping_keysyms(mapping.get()) : nullptr;
  for (int i = 0; i < count && width > 0; ++i)
  {
    if (symbols[i * width] == EscapeSymbol)
    {
      keys.push_back(static_cast<xcb_keycode_t>(setup->min_keycode + i));
    }
  }
  return keys;
}

bool Grab(xcb_connection_t* connection, xcb_window_t window)
{
  bool any = false;
  for (const xcb_keycode_t key : FindKeys(connection))
  {
    const auto error = Own(xcb_request_check(connection,
      xcb_grab_key_checked(
        connection, 0, window, XCB_MOD_MASK_ANY, key, XCB_GRAB_MODE_ASYNC, XCB_GRAB_MODE_ASYNC)));
    any = any || !error;
  }
  return any;
}
}

EscapeKey::EscapeKey(xcb_connection_t* connection)
  : Connection(connection)
{
}

EscapeKey::~EscapeKey()
{
  // The X server releases the grabs of a connection that ends.
  xcb_disconnect(this->Connection);
}

std::unique_ptr<EscapeKey> EscapeKey::Listen()
{
  int screen = 0;
  std::unique_ptr<EscapeKey> key(new EscapeKey(xcb_connect(nullptr, &screen)));
  if (xcb_connection_has_error(key->Connection))
  {
    return nullptr;
  }
  xcb_screen_iterator_t screens = xcb_setup_roots_iterator(xcb_get_setup(key->Connection));
  for (; screen > 0 && screens.rem > 1; --screen)
  {
    xcb_screen_next(&screens);
  }
  const xcb_window_t window = FindOwnWindow(key->Connection, screens.data->root);
  return window != NoWindow && Grab(key->Connection, window) ? std::move(key) : nullptr;
}

bool EscapeKey::WasPressed()
{
  while (const auto event = Own(xcb_poll_for_event(this->Connection)))
  {
    this->Pressed = this->Pressed || (event->response_type & 0x7f) == XCB_KEY_PRESS;
  }
  return this->Pressed;
}
}

#else

namespace sm
{
EscapeKey::EscapeKey(xcb_connection_t* connection)
  : Connection(connection)
{
}

EscapeKey::~EscapeKey() = default;

std::unique_ptr<EscapeKey> EscapeKey::Listen()
{
  return nullptr;
}

bool EscapeKey::WasPressed()
{
  return this->Pressed;
}
}

#endif
