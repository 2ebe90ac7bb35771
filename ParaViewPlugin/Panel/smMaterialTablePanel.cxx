#include "smMaterialTablePanel.h"

#include "smMaterialTable.h"

#include "pqApplicationCore.h"
#include "pqInterfaceTracker.h"
#include "pqPropertyWidget.h"
#include "pqScalarValueListPropertyWidget.h"
#include "vtkSMProperty.h"

#include <QHeaderView>
#include <QTableView>
#include <QVBoxLayout>

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace
{
/// Fits the columns into the panel: numbers are shown whole, and names share what these leave.
void FitColumns(QHeaderView* header)
{
  header->setStretchLastSection(false);
  for (int column = 0; column < header->count(); ++column)
  {
    header->setSectionResizeMode(column, column < 2 ? QHeaderView::Stretch : QHeaderView::ResizeToContents);
  }
}

/// Newer versions of ParaView take other texts.
template <typename List>
void SetTitles(pqScalarValueListPropertyWidget* table, void (pqScalarValueListPropertyWidget::*set)(List&))
{
  std::remove_const_t<List> titles(sm::MaterialTableTitles.begin(), sm::MaterialTableTitles.end());
  (table->*set)(titles);
}

class TitledTable : public pqPropertyWidget
{
public:
  TitledTable(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
    : pqPropertyWidget(proxy, parent)
  {
    auto* table = new pqScalarValueListPropertyWidget(property, proxy, this);
    // As ParaView's own widget names it, so that recorded tests and macros find it.
    table->setObjectName("ScalarValueList");
    SetTitles(table, &pqScalarValueListPropertyWidget::setLabels);
    table->setShowLabels(true);
    if (auto* view = table->findChild<QTableView*>())
    {
      view->verticalHeader()->hide();
      QHeaderView* header = view->horizontalHeader();
      FitColumns(header);
      QObject::connect(header, &QHeaderView::sectionCountChanged, header, [header]() { FitColumns(header); });
    }
    this->addPropertyLink(table, "scalars", SIGNAL(scalarsChanged()), property);
    this->setChangeAvailableAsChangeFinished(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(table);
    this->setShowLabel(false);
  }
};
}

pqPropertyWidget* smMaterialTablePanel::createWidgetForProperty(
  vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
{
  const char* widget = property ? property->GetPanelWidget() : nullptr;
  return widget && std::strcmp(widget, "solidmoments_material_table") == 0
    ? new TitledTable(proxy, property, parent)
    : nullptr;
}

/// Adds the table to ParaView's window; returns false without one.
extern "C" Q_DECL_EXPORT bool smRegisterPanel()
{
  pqApplicationCore* core = pqApplicationCore::instance();
  if (!core || !core->interfaceTracker())
  {
    return false;
  }
  core->interfaceTracker()->addInterface(new smMaterialTablePanel(core->interfaceTracker()));
  return true;
}
