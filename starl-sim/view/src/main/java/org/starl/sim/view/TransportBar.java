package org.starl.sim.view;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.util.List;
import java.util.Locale;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import org.starl.sim.replay.Mark;
import org.starl.sim.replay.Recording;

/** Buttons for the playback, and its state. */
final class TransportBar {

  private final Session session;
  private final JPanel panel = new JPanel();
  private final JButton play;
  private final JComboBox<String> speed = new JComboBox<>();
  private final JLabel time = figure("0000.000 s of 0000.000 s");
  private final JLabel event = figure("event 0000000 of 0000000");
  private final JLabel rate = figure("0000000 events/s");
  private final JLabel marks = new JLabel();
  private boolean isReading;

  TransportBar(Session session, Commands commands) {
    this.session = session;
    panel.setLayout(new BoxLayout(panel, BoxLayout.X_AXIS));
    panel.setBorder(BorderFactory.createEmptyBorder(2, 12, 8, 12));
    play = button(commands.play, Glyph.PLAY);
    for (Component part :
        List.of(
            button(commands.first, Glyph.FIRST),
            button(commands.eventBack, Glyph.EVENT_BACK),
            button(commands.back, Glyph.STEP_BACK),
            play,
            button(commands.on, Glyph.STEP),
            button(commands.event, Glyph.EVENT),
            button(commands.last, Glyph.LAST))) {
      panel.add(part);
    }
    panel.add(Box.createHorizontalStrut(10));
    speeds();
    panel.add(speed);
    for (JLabel figure : List.of(time, event, rate)) {
      panel.add(Box.createHorizontalStrut(18));
      panel.add(figure);
    }
    panel.add(Box.createHorizontalGlue());
    panel.add(marks);
    panel.add(Box.createHorizontalStrut(8));
    panel.add(button(commands.violationBefore, Glyph.PREVIOUS_MARK));
    panel.add(button(commands.violationAfter, Glyph.NEXT_MARK));
  }

  JPanel panel() {
    return panel;
  }

  private static JButton button(Command command, Icon icon) {
    JButton button = new JButton(command);
    button.setHideActionText(true);
    button.setIcon(icon);
    button.setFocusable(false);
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    button.getAccessibleContext().setAccessibleName(command.name());
    return button;
  }

  /** A label with a fixed width, so that the bar does not move with every digit. */
  private static JLabel figure(String widest) {
    JLabel label = new JLabel(widest);
    label.setFont(new Font(Font.MONOSPACED, Font.PLAIN, 12));
    Dimension size = label.getPreferredSize();
    label.setMinimumSize(size);
    label.setPreferredSize(size);
    label.setMaximumSize(size);
    label.setText("");
    return label;
  }

  private void speeds() {
    for (double each : Playback.SPEEDS) {
      speed.addItem(name(each));
    }
    speed.setFocusable(false);
    speed.setMaximumRowCount(Playback.SPEEDS.size());
    speed.setToolTipText("Simulated seconds per real second (\u2191 \u2193)");
    speed.setMaximumSize(speed.getPreferredSize());
    speed.addActionListener(event -> {
      int index = speed.getSelectedIndex();
      if (!isReading && index >= 0 && index < Playback.SPEEDS.size()) {
        session.playback().setSpeed(Playback.SPEEDS.get(index));
      }
    });
  }

  static String name(double speed) {
    if (speed == Playback.NO_LIMIT) {
      return "no limit";
    }
    return (speed == Math.rint(speed)
            ? Long.toString((long) speed)
            : String.format(Locale.ROOT, "%s", speed))
        + "x";
  }

  /** Updates buttons and figures. */
  void read() {
    Playback playback = session.playback();
    play.setIcon(playback.isPlaying() ? Glyph.PAUSE : Glyph.PLAY);
    isReading = true;
    speed.setSelectedIndex(nearest(playback.speed()));
    isReading = false;
    time.setText(
        Inspection.seconds(playback.nowNs())
            + " of "
            + Inspection.seconds(session.recording().endNs()));
    event.setText("event " + playback.index() + " of " + session.recording().size());
    boolean isMoving = playback.isPlaying() || !session.recording().isOver();
    rate.setText(isMoving ? Math.round(session.eventsPerSecond()) + " events/s" : "");
    long violations = violations(session.recording().marks());
    marks.setText(found(violations) + openText(session.recording()));
    marks.setForeground(
        violations == 0
            ? session.view().look().theme().muted()
            : session.view().look().theme().alarm());
  }

  private static int nearest(double speed) {
    int best = 0;
    for (int i = 0; i < Playback.SPEEDS.size(); i++) {
      best = Playback.SPEEDS.get(i) <= speed ? i : best;
    }
    return best;
  }

  private static long violations(List<Mark> marks) {
    return marks.stream().filter(mark -> mark.kind() == Mark.Kind.VIOLATION).count();
  }

  private static String found(long violations) {
    return switch ((int) Math.min(violations, 2)) {
      case 0 -> "no violation";
      case 1 -> "1 violation";
      default -> violations + " violations";
    };
  }

  /** The progress of checking; empty when all is checked. */
  static String openText(Recording recording) {
    if (recording.isChecked()) {
      return "";
    }
    long percent = 100L * recording.checked() / Math.max(1, recording.size());
    return " so far, " + percent + "% checked";
  }
}
