package org.starl.sim.view;

import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JOptionPane;
import javax.swing.JPopupMenu;
import javax.swing.SwingUtilities;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.sim.replay.LiveRun;

/** Interventions of the user in a live run: menus and dialogs for faults and points. */
final class Interventions {

  private static final int MOST_LINKS = 24;

  private final Session session;
  private final Component owner;
  private final Consumer<String> outcomes;

  /**
   * @param owner parent of dialogs
   * @param outcomes receives the outcome, in one line
   */
  Interventions(Session session, Component owner, Consumer<String> outcomes) {
    this.session = session;
    this.owner = owner;
    this.outcomes = outcomes;
  }

  /** A fault and its title in a menu. */
  record Item(String title, String fault) {}

  /** Faults of one robot. */
  static List<Item> faults(RobotId robot) {
    return List.of(
        new Item("Crash", "crash(" + robot + ")"),
        new Item("Crash, restart after 5 s", "crash(" + robot + ",restart=5s)"),
        new Item("Wheels stuck for 5 s", "stuck(" + robot + ",for=5s)"),
        new Item("Wheels at half speed for 10 s", "slow(" + robot + ",0.5,for=10s)"),
        new Item("No position fixes for 5 s", "dropout(" + robot + ",for=5s)"),
        new Item("Position noise of 100 mm for 10 s", "noise(" + robot + ",100mm,3deg,for=10s)"),
        new Item("Lose all sent messages for 5 s", "loss(1,from=" + robot + ",for=5s)"),
        new Item("Lose all received messages for 5 s", "loss(1,to=" + robot + ",for=5s)"),
        new Item("Obstacle in front of it for 10 s", "block(" + robot + ",for=10s)"));
  }

  /** The fault of a link. */
  static Item link(RobotId from, RobotId to) {
    return new Item(
        "To " + to + ": lose all messages for 10 s",
        "loss(1,from=" + from + ",to=" + to + ",for=10s)");
  }

  /** The menu at a place on the floor, with the robot there, if any. */
  JPopupMenu menu(@Nullable RobotId robot, Point place) {
    JPopupMenu menu = new JPopupMenu();
    RobotId selected = session.selected();
    if (selected != null) {
      String where = Math.round(place.xMm()) + ", " + Math.round(place.yMm());
      menu.add(item("Send point " + where + " to " + selected, () -> send(selected, place)));
    }
    if (robot != null) {
      if (selected != null) {
        menu.addSeparator();
      }
      for (Item item : faults(robot)) {
        menu.add(item(robot + ": " + lower(item.title()), () -> inject(item.fault())));
      }
      JMenu links = new JMenu("Link from " + robot);
      List<RobotId> others = new ArrayList<>(session.scene().robots());
      others.remove(robot);
      for (RobotId other : others.subList(0, Math.min(MOST_LINKS, others.size()))) {
        Item item = link(robot, other);
        links.add(item(item.title(), () -> inject(item.fault())));
      }
      links.setEnabled(session.live() != null && !others.isEmpty());
      menu.add(links);
    }
    if (menu.getComponentCount() > 0) {
      menu.addSeparator();
    }
    menu.add(item("Another fault\u2026", this::askFault));
    if (session.live() == null) {
      JMenuItem why = new JMenuItem("Only during a live run (starl run APP --view)");
      why.setEnabled(false);
      menu.addSeparator();
      menu.add(why);
    }
    return menu;
  }

  private static String lower(String title) {
    return Character.toLowerCase(title.charAt(0)) + title.substring(1);
  }

  private JMenuItem item(String title, Runnable action) {
    JMenuItem item = new JMenuItem(title);
    item.addActionListener(event -> action.run());
    item.setEnabled(session.live() != null);
    return item;
  }

  /** Asks for a fault in a dialog. */
  void askFault() {
    if (!isLive()) {
      return;
    }
    RobotId robot = session.selected();
    String text =
        ask(
            "Inject a fault",
            "A fault, written as for --fault. It begins now unless it has a time (at=...).",
            robot == null ? "loss(0.5,for=10s)" : "crash(" + robot + ",restart=5s)");
    if (!text.isEmpty()) {
      inject(text);
    }
  }

  /** Asks for a point in a dialog. */
  void askPoint() {
    RobotId robot = addressee();
    if (robot == null) {
      return;
    }
    String text = ask("Send a point", "Point for " + robot + ": x, y in mm", "0, 0");
    if (!text.isEmpty()) {
      String[] xy = text.split("[ ,;]+", -1);
      try {
        send(robot, new Point(Double.parseDouble(xy[0]), Double.parseDouble(xy[1])));
      } catch (NumberFormatException | ArrayIndexOutOfBoundsException e) {
        outcomes.accept("'" + text + "': expected two numbers, such as 1500, 700");
      }
    }
  }

  /** The user's answer; empty if the dialog was cancelled. */
  private String ask(String title, String question, String example) {
    int kind = JOptionPane.PLAIN_MESSAGE;
    Object text = JOptionPane.showInputDialog(owner, question, title, kind, null, null, example);
    return text == null ? "" : text.toString().strip();
  }

  /** Sends a point to the selected robot. */
  void sendSelected(Point place) {
    RobotId robot = addressee();
    if (robot != null) {
      send(robot, place);
    }
  }

  /** The robot that receives points; if there is none, shows the reason and returns null. */
  private @Nullable RobotId addressee() {
    if (!isLive()) {
      return null;
    }
    if (session.selected() == null) {
      outcomes.accept("Select a robot first: click it or press Tab");
    }
    return session.selected();
  }

  private boolean isLive() {
    if (session.live() == null) {
      outcomes.accept("The run has ended: faults and points need a live run");
      return false;
    }
    return true;
  }

  void inject(String fault) {
    LiveRun live = session.live();
    if (live != null) {
      try {
        report(live.fault(fault), fault);
      } catch (BadInput e) {
        outcomes.accept(e.getMessage());
      }
    }
  }

  void send(RobotId robot, Point place) {
    LiveRun live = session.live();
    if (live != null) {
      int x = (int) Math.round(place.xMm());
      int y = (int) Math.round(place.yMm());
      report(live.point(robot, x, y), "point " + x + ", " + y + " sent to " + robot);
    }
  }

  private void report(CompletableFuture<Long> done, String what) {
    var unused =
        done.whenComplete((atNs, error) -> {
          String line =
              error == null
                  ? "At " + Inspection.seconds(atNs) + ": " + what
                  : String.valueOf(error.getMessage());
          SwingUtilities.invokeLater(() -> outcomes.accept(line));
        });
  }
}
