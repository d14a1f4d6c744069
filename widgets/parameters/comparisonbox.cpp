// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/comparisonbox.h"

#include "widgets/common/clocktext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/parameters/axisparameters.h"
#include "widgets/parameters/editdesk.h"

#include <QComboBox>
#include <QDateTime>
#include <QLabel>
#include <QMenu>

#include <algorithm>

namespace mb {
namespace {

enum Comparison { WithDefaults, AsFound, WithFile, ChooseFile, WithAxis }; // and the axis on top of it

} // namespace

ComparisonBox::ComparisonBox(Workbench &workbench, Selection &selection, ParameterModel &model, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_selection(selection)
    , m_model(model)
{
    auto *row = layoutIn<QHBoxLayout>(this);
    auto *with = new QLabel(tr("Compare with"), this);
    setTextRole(*with, TextRole::Caption);
    setTone(*with, Tone::Dim);
    m_box = new QComboBox(this);
    m_box->setAccessibleName(tr("Compare with"));
    m_box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    with->setBuddy(m_box);
    row->addWidget(with);
    row->addWidget(m_box);
    connect(m_box, qOverload<int>(&QComboBox::activated), this, &ComparisonBox::choose);
}

void ComparisonBox::remember(const DeviceView &device)
{
    if (m_asFound.contains(device.id))
        return;
    const bool complete = std::all_of(device.parameters->begin(), device.parameters->end(),
        [](const auto &entry) { return entry.raw && entry.state != ParameterState::Failed; });
    if (!complete)
        return;
    const QDateTime now = momentOf(m_workbench, m_workbench.now());
    ParameterReference found{tr("as found %1").arg(clockText(now, ClockPart::Minutes)), {}};
    for (const auto &entry : *device.parameters)
        found.raws.push_back(entry.raw);
    m_asFound.emplace(device.id, std::move(found));
    if (m_model.edits() && m_model.edits() == EditDesk::of(m_workbench).find(device.id))
        refresh();
}

void ComparisonBox::compareWith(ParameterReference file)
{
    m_file = file;
    m_axis = 0;
    m_model.setReference(std::move(file));
    refresh();
}

void ComparisonBox::forgetFile()
{
    m_file.reset();
    m_axis = 0;
}

void ComparisonBox::forgetAxis()
{
    if (m_axis > 0)
        m_model.setReference(defaultsOf(*m_model.family()));
    m_axis = 0;
}

void ComparisonBox::refresh()
{
    m_box->clear();
    m_box->addItem(tr("defaults"), WithDefaults);
    const auto found = m_model.isWritable() ? m_asFound.find(m_selection.device()) : m_asFound.end();
    if (found != m_asFound.end())
        m_box->addItem(found->second.title, AsFound);
    if (m_file)
        m_box->addItem(m_file->title, WithFile);
    const Family *family = m_model.family();
    for (int axis = 1; family && m_selection.axis() > 0 && axis <= family->capabilities.axes; ++axis) {
        if (axis != m_selection.axis())
            m_box->addItem(tr("axis %1").arg(axis), WithAxis + axis);
    }
    m_box->addItem(tr("a file…"), ChooseFile);
    const int shown = m_box->findText(m_model.reference().title);
    m_box->setCurrentIndex(std::max(0, shown));
}

void ComparisonBox::addTo(QMenu &menu)
{
    QMenu *const with = menu.addMenu(tr("Compare with"));
    for (int row = 0; row < m_box->count(); ++row) {
        QAction *action = with->addAction(m_box->itemText(row), this, [this, row] { choose(row); });
        action->setCheckable(true);
        action->setChecked(row == m_box->currentIndex());
    }
    with->setEnabled(m_model.family() != nullptr);
}

void ComparisonBox::choose(int row)
{
    if (!m_model.family())
        return;
    const int chosen = m_box->itemData(row).toInt();
    if (chosen != ChooseFile)
        m_axis = std::max(0, chosen - WithAxis);
    switch (chosen) {
    case WithDefaults: m_model.setReference(defaultsOf(*m_model.family())); break;
    case AsFound: m_model.setReference(m_asFound.at(m_selection.device())); break;
    case WithFile: m_model.setReference(*m_file); break;
    case ChooseFile: Q_EMIT fileRequested(); break;
    default: m_model.setReference(axisReference(*m_model.family(), *m_model.edits(), m_axis)); break;
    }
    refresh();
}

} // namespace mb
