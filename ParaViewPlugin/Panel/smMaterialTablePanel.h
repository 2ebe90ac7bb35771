/**
 * @file smMaterialTablePanel.h
 * @brief The table of materials in ParaView's panel, with a row of titles that stays when the rows scroll
 *
 * ParaView's own widget of a repeatable property of texts, whose table has no titles: this one sets them. It
 * is a library of its own, which links Qt and which only ParaView's window loads (smPanel.h).
 */
#ifndef smMaterialTablePanel_h
#define smMaterialTablePanel_h

#include "pqPropertyWidgetInterface.h"

#include <QObject>

class smMaterialTablePanel
  : public QObject
  , public pqPropertyWidgetInterface
{
  Q_OBJECT
  Q_INTERFACES(pqPropertyWidgetInterface)

public:
  using QObject::QObject;

  /// Returns the table for a property with panel_widget="solidmoments_material_table", null for others.
  pqPropertyWidget* createWidgetForProperty(
    vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent) override;
};

#endif
