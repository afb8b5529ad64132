package org.starl.sim.view;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Component;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.BoxLayout;
import javax.swing.DefaultListModel;
import javax.swing.Icon;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ListCellRenderer;
import javax.swing.ListSelectionModel;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.sim.record.Painter;

/** The legend: all robots in their colours, and what the app tells about each. */
final class RobotList {

  private static final int MOST_LINES = 2;

  private final Session session;
  private final JList<RobotId> list = new JList<>();
  private final JScrollPane pane = new JScrollPane(list);
  private List<RobotId> shown = List.of();
  private int lines = 1;

  RobotList(Session session, Consumer<@Nullable RobotId> selected) {
    this.session = session;
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.setFocusable(false);
    list.setCellRenderer(new Cell());
    list.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mousePressed(MouseEvent event) {
            int index = list.locationToIndex(event.getPoint());
            if (index >= 0 && list.getCellBounds(index, index).contains(event.getPoint())) {
              selected.accept(list.getModel().getElementAt(index));
            } else {
              selected.accept(null);
            }
          }
        });
    pane.setBorder(BorderFactory.createEmptyBorder());
  }

  JScrollPane pane() {
    return pane;
  }

  /** Updates the list. */
  void read() {
    List<RobotId> robots = session.scene().robots();
    int wanted = linesOf(robots);
    if (!robots.equals(shown) || wanted != lines) {
      shown = robots;
      lines = wanted;
      DefaultListModel<RobotId> model = new DefaultListModel<>();
      model.addAll(robots);
      list.setModel(model);
      Font font = list.getFont();
      int high = list.getFontMetrics(font).getHeight();
      list.setFixedCellHeight(high * (1 + lines) + 10);
    }
    RobotId selected = session.selected();
    RobotId marked = list.getSelectedValue();
    if (selected == null) {
      list.clearSelection();
    } else if (!selected.equals(marked)) {
      list.setSelectedValue(selected, true);
    }
    list.repaint();
  }

  /** Number of text lines under a robot's name. */
  private int linesOf(List<RobotId> robots) {
    int most = lines;
    for (int i = 0; i < Math.min(20, robots.size()); i++) {
      String text = session.playback().layer().describe(robots.get(i), session.scene());
      most = Math.max(most, (int) Math.min(MOST_LINES, text.lines().count()));
    }
    return most;
  }

  private final class Cell implements ListCellRenderer<RobotId> {
    private final JPanel panel = new JPanel(new BorderLayout(8, 0));
    private final JLabel dot = new JLabel();
    private final JLabel name = new JLabel();
    private final JLabel state = new JLabel();
    private final JPanel text = new JPanel();
    private final JLabel[] rows = {new JLabel(), new JLabel()};

    Cell() {
      JPanel head = new JPanel(new BorderLayout(8, 0));
      head.setOpaque(false);
      head.add(name, BorderLayout.WEST);
      head.add(state, BorderLayout.EAST);
      text.setOpaque(false);
      text.setLayout(new BoxLayout(text, BoxLayout.Y_AXIS));
      head.setAlignmentX(0);
      text.add(head);
      for (JLabel row : rows) {
        row.setAlignmentX(0);
        text.add(row);
      }
      dot.setVerticalAlignment(JLabel.TOP);
      dot.setBorder(BorderFactory.createEmptyBorder(2, 0, 0, 0));
      panel.add(dot, BorderLayout.WEST);
      panel.add(text, BorderLayout.CENTER);
      panel.setBorder(BorderFactory.createEmptyBorder(5, 12, 5, 12));
    }

    @Override
    public Component getListCellRendererComponent(
        JList<? extends RobotId> in,
        RobotId robot,
        int index,
        boolean isSelected,
        boolean hasFocus) {
      var theme = session.view().look().theme();
      Color ink = in.getForeground();
      Color faint = theme.muted();
      panel.setBackground(isSelected ? Tones.selection() : in.getBackground());
      dot.setIcon(new Dot(session.view().look().robot(session.scene(), robot)));
      name.setText(robot.name());
      name.setFont(in.getFont().deriveFont(Font.BOLD));
      name.setForeground(ink);
      boolean isDown = session.scene().isDown(robot);
      boolean isGone = session.scene().pose(robot).isEmpty();
      state.setText(isDown ? "crashed" : isGone ? "not on the floor" : "");
      state.setForeground(isDown ? theme.alarm() : faint);
      List<String> description =
          session.playback().layer().describe(robot, session.scene()).lines().toList();
      for (int i = 0; i < rows.length; i++) {
        rows[i].setVisible(i < lines);
        rows[i].setText(i < description.size() ? description.get(i) : " ");
        rows[i].setForeground(i == 0 ? ink : faint);
      }
      panel.setToolTipText(description.isEmpty() ? null : String.join("; ", description));
      return panel;
    }
  }

  /** A disc in a robot's colour. */
  private record Dot(Color colour) implements Icon {

    @Override
    public int getIconWidth() {
      return 12;
    }

    @Override
    public int getIconHeight() {
      return 12;
    }

    @Override
    public void paintIcon(Component on, Graphics graphics, int x, int y) {
      Graphics2D page = (Graphics2D) graphics.create();
      Painter.smooth(page);
      page.setColor(colour);
      page.fill(new Ellipse2D.Double(x, y, 12, 12));
      page.dispose();
    }
  }
}
