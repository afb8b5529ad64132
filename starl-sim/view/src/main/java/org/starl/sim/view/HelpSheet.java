package org.starl.sim.view;

import java.awt.Component;
import java.awt.Dimension;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JEditorPane;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.WindowConstants;

/** Explains all keys and marks. */
final class HelpSheet {

  private static final String[][] MARKS = {
    {"disc with a line", "robot at its true position; the line shows its heading"},
    {"cross on a robot", "the robot's program has crashed"},
    {"ring around a robot", "the robot is selected"},
    {"grey lines and areas", "obstacles that all robots know"},
    {"orange-red lines and areas", "hidden obstacles: on no robot's map at the start"},
    {"burst of red lines", "a robot bumped into something in the last 10 s"},
    {"line in a robot's colour", "trail of the robot"},
    {"dots in a robot's colour", "planned route of the robot"},
    {"dot on an arc", "message in transit, in its sender's colour; a red cross: lost message"},
    {"red flag on the timeline", "violation of a specification"},
    {"cross, ring on the timeline", "crash, restart of a robot"},
    {"short line on the timeline", "begin or end of a fault"},
    {"diamond on the timeline", "intervention by the user"}
  };

  private HelpSheet() {}

  static void show(Component owner, Commands commands) {
    JEditorPane text = new JEditorPane("text/html", html(commands));
    text.setEditable(false);
    text.setCaretPosition(0);
    text.setBorder(BorderFactory.createEmptyBorder(8, 16, 16, 16));
    JDialog dialog = new JDialog(SwingUtilities.getWindowAncestor(owner), "Keys and marks");
    dialog.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
    JScrollPane pane = new JScrollPane(text);
    pane.setBorder(BorderFactory.createEmptyBorder());
    pane.setPreferredSize(new Dimension(1060, 720));
    dialog.getContentPane().add(pane);
    dialog
        .getRootPane()
        .registerKeyboardAction(
            pressed -> dialog.dispose(),
            KeyStroke.getKeyStroke("ESCAPE"),
            JComponent.WHEN_IN_FOCUSED_WINDOW);
    dialog.pack();
    dialog.setLocationRelativeTo(owner);
    dialog.setVisible(true);
  }

  static String html(Commands commands) {
    StringBuilder html = new StringBuilder("<html><body><table cellpadding=2><tr valign=top>");
    html.append("<td width=330>");
    for (String group : Commands.groups()) {
      if (group.equals("Floor") || group.equals("Picture")) {
        html.append("</td><td width=330>");
      }
      html.append("<h3>").append(group).append("</h3><table cellpadding=1>");
      for (Command command : commands.of(group)) {
        row(html, command.keys(), command.name().replace("\u2026", ""));
      }
      if (group.equals("Floor")) {
        row(html, "drag", "Move the floor");
        row(html, "wheel", "Zoom at the mouse pointer");
      } else if (group.equals("Robots")) {
        row(html, "click", "Select a robot");
        row(html, "shift click", "Send the selected robot this point");
        row(html, "right click", "Menu of faults and points");
      }
      html.append("</table>");
    }
    html.append("</td></tr></table><h3>Marks</h3><table cellpadding=1>");
    for (String[] mark : MARKS) {
      row(html, 190, mark[0], mark[1]);
    }
    return html.append("</table></body></html>").toString();
  }

  private static void row(StringBuilder html, String left, String right) {
    row(html, 110, left, right);
  }

  private static void row(StringBuilder html, int widthPx, String left, String right) {
    html.append("<tr><td width=").append(widthPx).append("><b>").append(left);
    html.append("</b></td><td>").append(right).append("</td></tr>");
  }
}
