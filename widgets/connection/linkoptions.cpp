// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/linkoptions.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>

namespace mb {
namespace {

constexpr int rates[] = {57600, 115200, 9600, 19200, 38400}; ///< bit/s, as often as they are met
constexpr int clocks[] = {500000, 250000, 100000};           ///< Hz; the first is the usual one
constexpr double losses[] = {0.01, 0.05, 0.1};

/// What was chosen, or typed.
QString chosen(const QComboBox &box)
{
    const int at = box.findText(box.currentText());
    return at >= 0 ? box.itemData(at).toString() : box.currentText().trimmed();
}

void showRow(QFormLayout &form, QWidget &field, bool on)
{
    field.setVisible(on);
    if (QWidget *label = form.labelForField(&field))
        label->setVisible(on);
}

} // namespace

LinkOptions::LinkOptions(QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("linkOptions"));
    m_form = new QFormLayout(this);
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setRowWrapPolicy(QFormLayout::WrapAllRows);
    buildSerial();
    buildSpi();
    buildSimulated();
    setLines({});
    setKind(LinkChoice::Kind::Can);
}

QComboBox *LinkOptions::addBox(const QString &name, const char *objectName)
{
    auto *box = new QComboBox(this);
    box->setObjectName(QLatin1String(objectName));
    box->setAccessibleName(name);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(16);
    m_form->addRow(name, box);
    connect(box, &QComboBox::currentTextChanged, this, &LinkOptions::changed);
    return box;
}

void LinkOptions::buildSerial()
{
    m_baud = addBox(tr("Bit rate"), "linkBaud");
    m_baud->addItem(tr("find it: all rates of the protocol"), QString());
    for (const int rate : rates)
        m_baud->addItem(tr("%1 bit/s").arg(QLocale().toString(rate)), QString::number(rate));
    m_rs485 = new QCheckBox(tr("the computer's own RS-485 port"), this);
    m_rs485->setAccessibleName(tr("RS-485"));
    m_rs485->setToolTip(
        tr("Lets the kernel switch the driver of a port on the computer's board. Adapters on USB switch by "
           "themselves: leave it off."));
    m_form->addRow(tr("RS-485"), m_rs485);
    connect(m_rs485, &QCheckBox::toggled, this, &LinkOptions::changed);
}

void LinkOptions::buildSpi()
{
    m_speed = addBox(tr("Clock"), "linkSpeed");
    for (const int clock : clocks)
        m_speed->addItem(tr("%1 kHz").arg(clock / 1000), QString::number(clock));
    m_ready = addBox(tr("Ready line (SRDY)"), "linkReady");
    m_reset = addBox(tr("Reset line (MCLR)"), "linkReset");
    for (QComboBox *box : {m_ready, m_reset})
        box->setEditable(true);
}

void LinkOptions::buildSimulated()
{
    m_loss = addBox(tr("Lost frames"), "linkLoss");
    m_loss->addItem(tr("none"), QString());
    for (const double loss : losses)
        m_loss->addItem(tr("%1 %").arg(loss * 100.0, 0, 'f', 0), QString::number(loss));
}

void LinkOptions::setLines(const std::vector<std::pair<QString, QString>> &lines)
{
    for (QComboBox *box : {m_ready, m_reset}) {
        const QSignalBlocker quiet(box);
        box->clear();
        box->addItem(tr("not wired"), QString());
        for (const auto &[name, label] : lines)
            box->addItem(label.isEmpty() ? name : tr("%1 (%2)").arg(name, label), name);
    }
}

void LinkOptions::setKind(LinkChoice::Kind kind)
{
    m_kind = kind;
    const bool serial = kind == LinkChoice::Kind::Serial;
    const bool spi = kind == LinkChoice::Kind::Spi;
    showRow(*m_form, *m_baud, serial);
    showRow(*m_form, *m_rs485, serial);
    for (QComboBox *box : {m_speed, m_ready, m_reset})
        showRow(*m_form, *box, spi);
    showRow(*m_form, *m_loss, kind == LinkChoice::Kind::Simulated);
}

std::vector<std::pair<std::string, std::string>> LinkOptions::options() const
{
    std::vector<std::pair<std::string, std::string>> options;
    const auto add = [&options](const char *key, const QString &value) {
        if (!value.isEmpty())
            options.emplace_back(key, value.toStdString());
    };
    if (m_kind == LinkChoice::Kind::Serial) {
        add("baud", chosen(*m_baud));
        add("rs485", m_rs485->isChecked() ? QStringLiteral("1") : QString());
    } else if (m_kind == LinkChoice::Kind::Spi) {
        add("speed", m_speed->currentIndex() == 0 ? QString() : chosen(*m_speed));
        add("ready", chosen(*m_ready));
        add("reset", chosen(*m_reset));
    } else if (m_kind == LinkChoice::Kind::Simulated) {
        add("loss", chosen(*m_loss));
    }
    return options;
}

} // namespace mb
