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

/** All keys, and what every mark means. */
final class HelpSheet {

  private static final String[][] MARKS = {
    {"disc with a line", "a robot's true body; the line points where it heads"},
    {"cross on a robot", "its program has crashed"},
    {"ring around a robot", "it is selected"},
    {"grey lines and areas", "obstacles that all robots know"},
    {"orange-red lines and areas", "hidden obstacles: on no robot's map at the start"},
    {"burst of red lines", "a robot ran into something, up to ten seconds ago"},
    {"line in a robot's colour", "its trail"},
    {"dots in a robot's colour", "where it means to go"},
    {"dot on an arc", "a message on its way, in its sender's colour; a red cross if it was lost"},
    {"red flag on the timeline", "a specification is violated"},
    {"cross, ring on the timeline", "a robot crashes; a robot restarts"},
    {"short line on the timeline", "a fault begins or ends"},
    {"diamond on the timeline", "somebody has intervened"}
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
        if (!command.keys().isEmpty()) {
          row(html, command.keys(), command.name().replace("\u2026", ""));
        }
      }
      if (group.equals("Floor")) {
        row(html, "drag", "Move the floor");
        row(html, "wheel", "Zoom where the mouse is");
      } else if (group.equals("Robots")) {
        row(html, "click", "Select a robot");
        row(html, "shift click", "Send the selected robot there");
        row(html, "right click", "Inject a fault, send a point");
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
