// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/service/productionhead.h"

#include "model/snapshot.h"
#include "widgets/common/captioned.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/holdbutton.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/scanfield.h"
#include "widgets/common/serviceview.h"
#include "widgets/common/wraplayout.h"
#include "widgets/service/recipetext.h"

#include <QComboBox>
#include <QLineEdit>

namespace mb {

ProductionHead::ProductionHead(const ThemeSource &theme, QString &chosen, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_chosen(chosen)
{
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    auto *facts = new QHBoxLayout;
    const int edge = theme.theme().u(16);
    facts->setContentsMargins(edge, theme.theme().u(10), edge, theme.theme().u(10));
    facts->setSpacing(edge);
    buildFacts(*facts);
    column->addLayout(facts);
    column->addWidget(separatorLine(Qt::Horizontal, this));
    auto *orders = new QWidget(this);
    buildOrders(*orders);
    column->addWidget(orders);
}

void ProductionHead::buildFacts(QHBoxLayout &row)
{
    m_name = addCaptioned(m_theme, tr("recipe"), TextRole::Emphasis, row, 2, this);
    m_image = addCaptioned(m_theme, tr("image"), TextRole::Body, row, 4, this);
    m_parameters = addCaptioned(m_theme, tr("parameters"), TextRole::Body, row, 2, this);
    m_number = addCaptioned(m_theme, tr("number rule"), TextRole::Body, row, 2, this);
    m_test = addCaptioned(m_theme, tr("self-test"), TextRole::Body, row, 3, this);
    auto *leave = new CommandButton(m_theme, tr("Leave"), this);
    leave->setKeyHint(QStringLiteral("F11"));
    row.addWidget(leave);
    connect(leave, &QPushButton::clicked, this, &ProductionHead::leaveWanted);
}

void ProductionHead::buildOrders(QWidget &orders)
{
    auto *row = new WrapLayout(&orders);
    const int edge = m_theme.theme().u(16);
    row->setContentsMargins(edge, m_theme.theme().u(8), edge, m_theme.theme().u(8));
    m_link = new QComboBox(&orders);
    m_link->setAccessibleName(tr("Link that units are put on"));
    m_serial = new ScanField(&orders);
    m_serial->setAccessibleName(tr("Serial number, scanned or typed"));
    m_serial->setPlaceholderText(tr("Scan or type a serial number"));
    m_serial->setMinimumWidth(m_theme.theme().u(270));
    auto *open = new CommandButton(m_theme, Symbol::Open, tr("Open recipe…"), &orders);
    m_arm = new HoldButton(m_theme, Symbol::Arm, tr("Hold to arm self-tests"), &orders);
    m_arm->setHoldNeeded(true);
    m_start = new CommandButton(m_theme, Symbol::Play, tr("Start"), &orders);
    m_start->setPrimary(true);
    m_start->setTextVariants({tr("Start"), tr("End")});
    row->addWidget(m_link);
    row->addWidget(m_serial);
    row->addSpring();
    for (QWidget *part : std::initializer_list<QWidget *>{open, m_arm, m_start})
        row->addWidget(part);
    connect(m_link, qOverload<int>(&QComboBox::activated), this, &ProductionHead::keepLink);
    connect(open, &QPushButton::clicked, this, &ProductionHead::recipeWanted);
    connect(m_start, &QPushButton::clicked, this, &ProductionHead::startWanted);
    connect(m_arm, &HoldButton::activated, this, &ProductionHead::armWanted);
    connect(m_serial, &QLineEdit::returnPressed, this, [this] {
        Q_EMIT serialTaken(m_serial->text().trimmed());
        m_serial->clear();
    });
    show(nullptr, false);
}

void ProductionHead::show(const service::RecipeMatter *matter, bool canStart)
{
    m_canStart = canStart;
    m_name->setText(matter ? recipeName(matter) : tr("No recipe yet"));
    m_image->setText(imageText(matter));
    m_parameters->setText(parameterText(matter));
    m_number->setText(numberText(matter));
    m_test->setText(testText(matter));
    m_arm->setVisible(matter && matter->recipe.test);
}

void ProductionHead::follow(const ServiceView &view)
{
    m_start->setEnabled(view.running || m_canStart);
    m_start->setRole(view.running ? tr("End") : tr("Start"));
    m_start->setSymbol(view.running ? Symbol::Pause : Symbol::Play);
    m_link->setEnabled(!view.running);
    m_arm->setEnabled(view.running);
    m_arm->setText(view.isArmed() ? tr("ARMED, hold to disarm") : tr("Hold to arm self-tests"));
}

void ProductionHead::follow(const Snapshot &shot, const ServiceView &view)
{
    const bool serves = view.running && !view.links.empty();
    const QString wanted = serves ? qt(view.links.front()) : m_chosen;
    const QString before = link();
    QStringList addresses;
    for (const LinkView &link : shot.links) {
        if (link.state == LinkState::Open)
            addresses << qt(link.address);
    }
    QStringList texts = addresses;
    if (!wanted.isEmpty() && !addresses.contains(wanted)) {
        addresses << wanted;
        texts << tr("%1, not open").arg(wanted);
    }
    QStringList known;
    for (int i = 0; i < m_link->count(); ++i)
        known << m_link->itemText(i);
    if (texts != known) {
        m_link->clear();
        for (int i = 0; i < texts.size(); ++i)
            m_link->addItem(texts[i], addresses[i]);
    }
    m_link->setCurrentIndex(std::max(0, m_link->findData(wanted.isEmpty() ? before : wanted)));
}

QString ProductionHead::link() const
{
    return m_link->currentData().toString();
}

} // namespace mb
