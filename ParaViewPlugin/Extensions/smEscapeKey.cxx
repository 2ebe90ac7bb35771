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
/// The keysym of Esc, XK_Escape of X's keysymdef.h.
constexpr xcb_keysym_t EscapeSymbol = 0xff1b;

constexpr xcb_window_t NoWindow = XCB_WINDOW_NONE;

/// Replies come from malloc.
template <typename T>
std::unique_ptr<T, decltype(&std::free)> Own(T* reply)
{
  return { reply, &std::free };
}
}

struct EscapeKey::Internals
{
  xcb_connection_t* Connection = nullptr;
  xcb_window_t Root = NoWindow;
  xcb_window_t Window = NoWindow;
  bool Pressed = false;

  ~Internals()
  {
    // The server drops the grabs of a connection that ends.
    xcb_disconnect(this->Connection);
  }

  bool IsOurs(xcb_window_t window, xcb_atom_t pidAtom) const
  {
    const auto property = Own(xcb_get_property_reply(this->Connection,
      xcb_get_property(this->Connection, 0, window, pidAtom, XCB_ATOM_CARDINAL, 0, 1), nullptr));
    if (!property || property->format != 32 || xcb_get_property_value_length(property.get()) != 4)
    {
      return false;
    }
    std::uint32_t pid = 0;
    std::memcpy(&pid, xcb_get_property_value(property.get()), sizeof(pid));
    return pid == static_cast<std::uint32_t>(getpid());
  }

  xcb_window_t GetActiveWindow() const
  {
    const auto focus =
      Own(xcb_get_input_focus_reply(this->Connection, xcb_get_input_focus(this->Connection), nullptr));
    if (focus && focus->focus > XCB_INPUT_FOCUS_POINTER_ROOT && focus->focus != this->Root)
    {
      return focus->focus;
    }
    const auto pointer = Own(
      xcb_query_pointer_reply(this->Connection, xcb_query_pointer(this->Connection, this->Root), nullptr));
    return pointer ? pointer->child : NoWindow;
  }

  /// Among the active window and those around it, one of this process.
  xcb_window_t FindOwnWindow() const
  {
    static const char name[] = "_NET_WM_PID";
    const auto atom = Own(xcb_intern_atom_reply(
      this->Connection, xcb_intern_atom(this->Connection, 1, sizeof(name) - 1, name), nullptr));
    xcb_window_t window = atom ? this->GetActiveWindow() : NoWindow;
    while (window != NoWindow && window != this->Root && !this->IsOurs(window, atom->atom))
    {
      const auto tree =
        Own(xcb_query_tree_reply(this->Connection, xcb_query_tree(this->Connection, window), nullptr));
      window = tree ? tree->parent : NoWindow;
    }
    return window == this->Root ? NoWindow : window;
  }

  std::vector<xcb_keycode_t> FindKeys() const
  {
    const xcb_setup_t* setup = xcb_get_setup(this->Connection);
    const int count = setup->max_keycode - setup->min_keycode + 1;
    const auto mapping = Own(xcb_get_keyboard_mapping_reply(this->Connection,
      xcb_get_keyboard_mapping(this->Connection, setup->min_keycode, static_cast<std::uint8_t>(count)),
      nullptr));
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

  bool Grab()
  {
    bool any = false;
    for (const xcb_keycode_t key : this->FindKeys())
    {
      const auto error = Own(xcb_request_check(this->Connection,
        xcb_grab_key_checked(this->Connection, 0, this->Window, XCB_MOD_MASK_ANY, key, XCB_GRAB_MODE_ASYNC,
          XCB_GRAB_MODE_ASYNC)));
      any = any || !error;
    }
    return any;
  }
};

EscapeKey::EscapeKey(std::unique_ptr<Internals> implementation)
  : Implementation(std::move(implementation))
{
}

EscapeKey::~EscapeKey() = default;

std::unique_ptr<EscapeKey> EscapeKey::Listen()
{
  int screen = 0;
  auto self = std::make_unique<Internals>();
  self->Connection = xcb_connect(nullptr, &screen);
  if (xcb_connection_has_error(self->Connection))
  {
    return nullptr;
  }
  xcb_screen_iterator_t screens = xcb_setup_roots_iterator(xcb_get_setup(self->Connection));
  for (; screen > 0 && screens.rem > 1; --screen)
  {
    xcb_screen_next(&screens);
  }
  self->Root = screens.data->root;
  self->Window = self->FindOwnWindow();
  if (self->Window == NoWindow || !self->Grab())
  {
    return nullptr;
  }
  return std::unique_ptr<EscapeKey>(new EscapeKey(std::move(self)));
}

bool EscapeKey::WasPressed()
{
  Internals& self = *this->Implementation;
  while (const auto event = Own(xcb_poll_for_event(self.Connection)))
  {
    self.Pressed = self.Pressed || (event->response_type & 0x7f) == XCB_KEY_PRESS;
  }
  return self.Pressed;
}
}

#else

namespace sm
{
struct EscapeKey::Internals
{
};

EscapeKey::EscapeKey(std::unique_ptr<Internals>) {}

EscapeKey::~EscapeKey() = default;

std::unique_ptr<EscapeKey> EscapeKey::Listen()
{
  return nullptr;
}

bool EscapeKey::WasPressed()
{
  return false;
}
}

#endif
