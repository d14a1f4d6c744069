// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/routepanel.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>

namespace mb {

RoutePanel::RoutePanel(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("updateRoute"));
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(theme.theme().u(16), theme.theme().u(10), theme.theme().u(16), theme.theme().u(10));
    row->setSpacing(theme.theme().u(12));
    row->addWidget(new SectionLabel(tr("Way in"), this));
    m_via = new QLineEdit(this);
    m_via->setAccessibleName(tr("Programmer"));
    m_via->setToolTip(tr("Programmer and where it is plugged in, as after --via on the command line"));
    m_via->setMaximumWidth(theme.theme().u(260));
    m_target = new QComboBox(this);
    m_target->setAccessibleName(tr("Microcontroller"));
    m_target->setToolTip(tr("Which microcontroller the unit has"));
    m_erase = new QCheckBox(tr("Erase what the unit has stored: its gains are lost"), this);
    row->addWidget(m_via, 1);
    row->addWidget(m_target);
    row->addWidget(m_erase);
    row->addStretch();
    setVisible(false);
}

void RoutePanel::show(const Family *family)
{
    setVisible(family && !family->routes.empty());
    if (family == m_family)
        return;
    m_family = family;
    if (!family || family->routes.empty())
        return;
    const UpdateRoute &route = family->routes.front();
    m_via->setText(qt(route.example));
    m_target->clear();
    for (const std::string_view target : route.targets)
        m_target->addItem(qt(target).toUpper(), qt(target));
    m_target->setVisible(!route.targets.empty());
    m_erase->setChecked(false);
    m_erase->setVisible(route.erasesSettings);
}

UpdateOptions RoutePanel::options() const
{
    UpdateOptions options;
    if (!m_family || m_family->routes.empty())
        return options;
    options.via = m_via->text().trimmed().toStdString();
    options.target = m_target->currentData().toString().toStdString();
    options.eraseSettings = m_erase->isChecked();
    return options;
}

} // namespace mb
