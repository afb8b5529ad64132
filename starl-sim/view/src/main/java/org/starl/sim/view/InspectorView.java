package org.starl.sim.view;

import java.awt.CardLayout;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import org.starl.id.RobotId;
import org.starl.sim.Failure;

/** Shows state, messages and log of the selected robot. */
final class InspectorView {

  private static final String HINT = "hint";
  private static final String ROBOT = "robot";

  private final Session session;
  private final CardLayout cards = new CardLayout();
  private final JPanel panel = new JPanel(cards);
  private final JLabel hint = new JLabel();
  private final JTabbedPane tabs = new JTabbedPane();
  private final Table state = new Table(104);
  private final Table messages = new Table(74, 62);
  private final Table log = new Table(74, 92);

  InspectorView(Session session) {
    this.session = session;
    tabs.setFocusable(false);
    tabs.addTab(
        "State", null, state.pane(), "Position, and variables of the app and of primitives");
    tabs.addTab(
        "Messages", null, messages.pane(), "Sent, received and lost messages, latest first");
    tabs.addTab("Log", null, log.pane(), "Actions, faults and log lines, latest first");
    hint.setBorder(BorderFactory.createEmptyBorder(8, 12, 8, 12));
    panel.add(hint, HINT);
    panel.add(tabs, ROBOT);
  }

  JPanel panel() {
    return panel;
  }

  /** Switches to the next page. */
  void turn() {
    tabs.setSelectedIndex((tabs.getSelectedIndex() + 1) % tabs.getTabCount());
  }

  /** Updates the visible page. */
  void read() {
    RobotId robot = session.selected();
    cards.show(panel, robot == null ? HINT : ROBOT);
    if (robot == null) {
      String text = "<html>" + hint() + "</html>";
      if (!text.equals(hint.getText())) {
        hint.setText(text);
      }
      return;
    }
    int index = session.playback().index();
    switch (tabs.getSelectedIndex()) {
      case 0 ->
          state.show(
              Inspection.state(session.scene(), robot).stream().map(InspectorView::row).toList());
      case 1 -> messages.show(rows(Inspection.messages(session.recording(), index, robot)));
      default -> log.show(rows(Inspection.log(session.recording(), index, robot)));
    }
  }

  /** What went wrong, and how to see more, in HTML. */
  private String hint() {
    StringBuilder text = new StringBuilder();
    Failure failure = session.recording().wentWrong();
    if (failure != null) {
      for (String line : failure.lines()) {
        boolean isFirst = text.isEmpty();
        text.append(isFirst ? "<p><b>" : "<p style='margin-top:6px'>")
            .append(line.replace("&", "&amp;").replace("<", "&lt;"))
            .append(isFirst ? "</b></p>" : "</p>");
      }
      text.append("<p style='margin-top:12px'>");
    }
    return text.append("Click a robot or press Tab to see its state, messages and log").toString();
  }

  private static Table.Row row(Inspection.Row row) {
    return row.isTitle()
        ? new Table.Row(true, List.of(row.name()), "")
        : new Table.Row(false, List.of(row.name(), row.value()), row.name() + ": " + row.value());
  }

  private static List<Table.Row> rows(List<Inspection.Line> lines) {
    return lines.stream()
        .map(line ->
            new Table.Row(
                false,
                List.of(Inspection.seconds(line.timeNs()), line.what(), line.text()),
                line.more()))
        .toList();
  }
}
