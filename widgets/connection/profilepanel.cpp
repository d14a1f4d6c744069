// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/profilepanel.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/guarded.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/numberformat.h"
#include "widgets/connection/experimentdialog.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>

namespace mb {

ProfilePanel::ProfilePanel(Workbench &workbench, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("profilePanel"));
    setAccessibleName(tr("What only you know"));
    m_column = layoutIn<QVBoxLayout>(this, theme.theme().u(6));
    setVisible(false);
}

void ProfilePanel::rebuild(const Family &family)
{
    m_family = &family;
    delete m_content;
    m_rows.clear();
    m_dialects = nullptr;
    m_content = new QWidget(this);
    m_column->addWidget(m_content);
    auto *column = layoutIn<QVBoxLayout>(m_content, m_theme.theme().u(6));
    column->addWidget(separatorLine(Qt::Horizontal, m_content));
    column->addWidget(new SectionLabel(tr("What only you know"), m_content));
    if (!family.dialects.empty())
        buildDialects(family, *column);
    for (const Calibration &calibration : family.calibrations) {
        if (calibration.choices.empty())
            buildRow(calibration, *column);
        else
            buildChoices(calibration, *column);
    }
    buildExperiments(family, *column);
    m_trouble = textLabel({}, TextRole::Caption, Tone::Danger, m_content);
    m_trouble->setWordWrap(true);
    m_trouble->setVisible(false);
    column->addWidget(m_trouble);
}

void ProfilePanel::buildDialects(const Family &family, QVBoxLayout &column)
{
    m_dialects = new QComboBox(m_content);
    m_dialects->setAccessibleName(tr("Dialect"));
    m_dialects->setToolTip(
        tr("How this unit is spoken to. The scan finds it out; choose another only if you know better."));
    m_dialects->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_dialects->addItem(tr("dialect as found"));
    for (const DialectChoice &choice : family.dialects)
        m_dialects->addItem(tableText(choice.title));
    column.addWidget(m_dialects);
    connect(m_dialects, qOverload<int>(&QComboBox::activated), this, &ProfilePanel::chooseDialect);
}

void ProfilePanel::buildRow(const Calibration &calibration, QVBoxLayout &column)
{
    auto *line = new QHBoxLayout;
    auto *caption = new ElidedLabel(tableText(calibration.label), m_content);
    setTone(*caption, Tone::Dim);
    auto *field = new NumberField(m_content);
    field->setAccessibleName(tableText(calibration.label));
    field->setToolTip(tableText(calibration.help));
    field->setPlaceholderText(tr("unknown"));
    field->setMaximumWidth(m_theme.theme().u(96));
    line->addWidget(caption, 1);
    line->addWidget(field);
    auto *unit = new ElidedLabel(tableText(calibration.unit), m_content);
    setTone(*unit, Tone::Dim);
    line->addWidget(unit);
    column.addLayout(line);
    const Row row{&calibration, field};
    m_rows.push_back(row);
    connect(field, &QLineEdit::editingFinished, this, [this, row] { typed(row); });
}

void ProfilePanel::buildChoices(const Calibration &calibration, QVBoxLayout &column)
{
    auto *caption = textLabel(tableText(calibration.label), TextRole::Body, Tone::Dim, m_content);
    auto *choices = new QComboBox(m_content);
    choices->setAccessibleName(tableText(calibration.label));
    choices->setToolTip(tableText(calibration.help));
    choices->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const Choice &choice : calibration.choices)
        choices->addItem(tableText(choice.label), static_cast<int>(choice.raw));
    column.addWidget(caption);
    column.addWidget(choices);
    const Row row{&calibration, nullptr, choices};
    m_rows.push_back(row);
    connect(choices, qOverload<int>(&QComboBox::activated), this, [this, row](int place) { chosen(row, place); });
}

void ProfilePanel::buildExperiments(const Family &family, QVBoxLayout &column)
{
    for (const Experiment &known : family.experiments) {
        auto *button = new QPushButton(tableText(known.title) + QStringLiteral("…"), m_content);
        button->setObjectName(qt(known.key));
        button->setAccessibleName(tableText(known.title));
        button->setToolTip(tableText(known.explanation));
        column.addWidget(button);
        connect(button, &QPushButton::clicked, this, [this, &known] { experiment(known); });
    }
}

void ProfilePanel::experiment(const Experiment &experiment)
{
    auto *dialog = new ExperimentDialog(m_workbench, m_device, experiment, m_theme, window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void ProfilePanel::chosen(const Row &row, int place)
{
    m_workbench.send(
        orders::Calibrate{m_device, std::string(row.calibration->key), row.choices->itemData(place).toDouble()},
        guarded(this, [this](const Result<void> &result) { say(result); }));
}

void ProfilePanel::typed(const Row &row)
{
    const QString text = row.field->text().trimmed();
    const auto number = parseNumber(text);
    if (!text.isEmpty() && !number) {
        setStyleProperty(*row.field, "state", QStringLiteral("error"));
        say(fail(Fault::OutOfRange, mb::say("%1: not a number", row.calibration->label)));
        return;
    }
    const DeviceView *device = m_workbench.snapshot().device(m_device);
    const double known = device ? device->profile->calibrated(row.calibration->key) : 0.0;
    if (text.isEmpty() ? known == 0.0 : *number == known)
        return;
    const QPointer<QLineEdit> field = row.field;
    m_workbench.send(
        orders::Calibrate{m_device, std::string(row.calibration->key), text.isEmpty() ? std::nullopt : number},
        guarded(this, [this, field](const Result<void> &result) {
            if (field)
                setStyleProperty(*field, "state", result ? QString() : QStringLiteral("error"));
            say(result);
        }));
}

void ProfilePanel::say(const Result<void> &result)
{
    m_trouble->setText(result ? QString() : errorText(result.error()));
    m_trouble->setVisible(!result);
}

/// What the scan found needs no question; anything else does.
void ProfilePanel::chooseDialect(int place)
{
    const auto finished = guarded(this, [this](const Result<void> &result) { say(result); });
    if (place == 0) {
        m_workbench.send(orders::SetDialect{m_device, {}}, finished);
        return;
    }
    const DialectChoice &choice = m_family->dialects[static_cast<std::size_t>(place - 1)];
    auto *question = new QMessageBox(QMessageBox::Warning, tr("Speak another dialect?"),
        tr("Speak to this unit as %1?").arg(tableText(choice.title)), QMessageBox::Cancel, this);
    question->setInformativeText(tableText(choice.warning));
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->addButton(tr("Speak it"), QMessageBox::AcceptRole);
    question->setDefaultButton(QMessageBox::Cancel);
    connect(question, &QMessageBox::buttonClicked, this,
        [this, question, key = std::string(choice.key), device = m_device, finished](QAbstractButton *button) {
            if (question->buttonRole(button) == QMessageBox::AcceptRole)
                m_workbench.send(orders::SetDialect{device, key}, finished);
            else
                show(m_workbench.snapshot().device(m_device));
        });
    question->open();
}

void ProfilePanel::showRow(const Row &row, const DeviceView &device, bool another)
{
    if (row.choices) {
        const double known = device.profile->calibrated(
            row.calibration->key, static_cast<double>(row.calibration->choices.front().raw));
        row.choices->setCurrentIndex(std::max(0, row.choices->findData(static_cast<int>(known))));
        return;
    }
    if (row.field->hasFocus() && !another)
        return;
    const double known = device.profile->calibrated(row.calibration->key);
    const QString text = known > 0.0 ? editText(known) : QString();
    if (row.field->text() != text && (another || row.field->property("state").toString().isEmpty()))
        row.field->setText(text);
}

void ProfilePanel::show(const DeviceView *device)
{
    const bool any = device
        && (!device->family->dialects.empty() || !device->family->calibrations.empty()
            || !device->family->experiments.empty());
    setVisible(any);
    if (!any)
        return;
    if (device->family != m_family)
        rebuild(*device->family);
    const bool another = device->id != m_device;
    m_device = device->id;
    for (const Row &row : m_rows)
        showRow(row, *device, another);
    if (!m_dialects)
        return;
    int place = 0;
    for (std::size_t i = 0; i < m_family->dialects.size(); ++i) {
        if (m_family->dialects[i].key == device->profile->dialect)
            place = static_cast<int>(i) + 1;
    }
    m_dialects->setCurrentIndex(place);
    m_dialects->setItemText(0,
        device->profile->dialect.empty() && !device->identity->dialect.empty()
            ? tr("dialect as found: %1").arg(QString::fromStdString(device->identity->dialect))
            : tr("dialect as found"));
}

} // namespace mb
