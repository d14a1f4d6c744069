// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/routepanel.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/wraplayout.h"
#include "widgets/firmware/programmerbox.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace mb {

RoutePanel::RoutePanel(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("updateRoute"));
    auto *column = layoutIn<QVBoxLayout>(
        this, theme.theme().u(8), {theme.theme().u(16), theme.theme().u(10), theme.theme().u(16), theme.theme().u(10)});
    auto *row = new WrapLayout;
    row->setSpacing(theme.theme().u(12));
    row->setLineSpacing(theme.theme().u(6));
    row->addWidget(new SectionLabel(tr("Way in"), this));
    m_via = new QComboBox(this);
    m_via->setEditable(true);
    m_via->setInsertPolicy(QComboBox::NoInsert);
    m_via->setAccessibleName(tr("Programmer"));
    m_via->setToolTip(tr("Programmer or port and where it is plugged in, as after --via on the command line"));
    m_via->setMinimumWidth(theme.theme().u(260));
    m_target = new QComboBox(this);
    m_target->setAccessibleName(tr("Microcontroller"));
    m_target->setToolTip(tr("Which microcontroller the unit has"));
    m_erase = new QCheckBox(tr("Erase what the unit has stored: its gains are lost"), this);
    m_erase->setObjectName(QStringLiteral("eraseSettings"));
    m_more = linkButton(tr("What is not known of it…"), this);
    m_more->setToolTip(tr("What the maker does not tell of the bootloader, with the likely values"));
    m_more->setCheckable(true);
    m_programmer = new ProgrammerBox(theme, this);
    row->addWidget(m_via);
    row->setStretched(m_programmer);
    row->addWidget(m_programmer);
    row->addWidget(m_target);
    row->addWidget(m_erase);
    row->addWidget(m_more);
    column->addLayout(row);
    connect(m_more, &QPushButton::toggled, this, [this](bool on) {
        if (m_settings)
            m_settings->setVisible(on);
    });
    setVisible(false);
    connect(m_programmer, &ProgrammerBox::changed, this, &RoutePanel::changed);
}

bool RoutePanel::hasProgrammers() const
{
    return m_family && !m_family->routes.empty() && !m_family->routes.front().programmers.empty();
}

QString RoutePanel::missing() const
{
    return hasProgrammers() ? m_programmer->missing() : QString();
}

void RoutePanel::show(const Family *family, const std::vector<LinkListing> &listings, const std::string &own)
{
    setVisible(family && !family->routes.empty());
    if (family && !family->routes.empty())
        listPorts(family->routes.front(), listings);
    m_programmer->listPorts(listings, own);
    if (family == m_family)
        return;
    m_family = family;
    if (!family || family->routes.empty())
        return;
    const UpdateRoute &route = family->routes.front();
    if (m_ports.isEmpty())
        m_via->setEditText(qt(route.example));
    m_via->setVisible(route.programmers.empty());
    m_programmer->setVisible(!route.programmers.empty());
    m_programmer->show(route);
    m_target->clear();
    for (const std::string_view target : route.targets)
        m_target->addItem(qt(target).toUpper(), qt(target));
    m_target->setVisible(!route.targets.empty());
    m_erase->setVisible(route.erasesSettings);
    buildFields(route);
}

/// A port that is plugged in while the page is open appears; what was typed stays.
void RoutePanel::listPorts(const UpdateRoute &route, const std::vector<LinkListing> &listings)
{
    QStringList ports;
    for (const LinkListing &listing : listings) {
        if (route.scheme == "serial" && listing.kind == LinkKind::Serial && listing.openable)
            ports += QString::fromStdString(listing.link.text());
    }
    if (ports == m_ports)
        return;
    const QString typed = m_via->currentText();
    const bool keep = !typed.isEmpty() && typed != qt(route.example);
    m_ports = ports;
    m_via->clear();
    m_via->addItems(ports);
    if (keep || ports.isEmpty())
        m_via->setEditText(keep ? typed : qt(route.example));
}

void RoutePanel::buildFields(const UpdateRoute &route)
{
    delete m_settings;
    m_settings = nullptr;
    m_fields.clear();
    m_more->setChecked(false);
    m_more->setVisible(!route.settings.empty());
    if (route.settings.empty())
        return;
    m_settings = new QWidget(this);
    auto *row = new WrapLayout(m_settings);
    row->setContentsMargins(0, 0, 0, 0);
    for (const UpdateSetting &setting : route.settings) {
        auto *pair = new QWidget(m_settings);
        auto *line = layoutIn<QHBoxLayout>(pair, -1, {0, 0, m_theme.theme().u(8), 0});
        auto *value = new QComboBox(pair);
        value->setAccessibleName(tableText(setting.label));
        value->setToolTip(tableText(setting.help));
        value->setEditable(setting.choices.empty());
        value->setInsertPolicy(QComboBox::NoInsert);
        if (setting.choices.empty())
            value->addItem(qt(setting.fallback));
        for (const std::string_view choice : setting.choices)
            value->addItem(qt(choice));
        value->setCurrentIndex(std::max(0, value->findText(qt(setting.fallback))));
        auto *caption = textLabel(tableText(setting.label), TextRole::Caption, Tone::Dim, pair);
        caption->setBuddy(value);
        line->addWidget(caption);
        line->addWidget(value);
        row->addWidget(pair);
        m_fields.push_back({&setting, value});
    }
    layout()->addWidget(m_settings);
    m_settings->setVisible(false);
}

void RoutePanel::keepSettings()
{
    m_erase->setChecked(false);
}

void RoutePanel::setVia(const QString &via)
{
    m_via->setEditText(via);
}

QString RoutePanel::viaWithSettings() const
{
    QString via = hasProgrammers() ? m_programmer->via() : m_via->currentText().trimmed();
    for (const Field &field : m_fields) {
        const QString value = field.value->currentText().trimmed();
        if (value != qt(field.setting->fallback) && !value.isEmpty())
            via += (via.contains(QLatin1Char('?')) ? QLatin1Char('&') : QLatin1Char('?')) + qt(field.setting->key)
                + QLatin1Char('=') + value;
    }
    return via;
}

UpdateOptions RoutePanel::options() const
{
    UpdateOptions options;
    if (!m_family || m_family->routes.empty())
        return options;
    options.via = viaWithSettings().toStdString();
    options.target = m_target->currentData().toString().toStdString();
    options.eraseSettings = m_erase->isChecked();
    return options;
}

} // namespace mb
