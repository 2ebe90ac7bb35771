/**
 * @file smPanel.h
 * @brief Widgets of the plugin in ParaView's panel, which only ParaView's window loads
 */
#ifndef smPanel_h
#define smPanel_h

namespace sm
{
/// Loads the library smParaViewPanel from the plugin's folder, the first time; returns true if the process
/// has ParaView's window and the library, which is not built without Qt's headers.
bool HasPanel();
}

#endif
