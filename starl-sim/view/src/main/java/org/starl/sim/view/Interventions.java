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

/** A person's interventions in a live run: by menu or as text. */
final class Interventions {

  private static final int MOST_LINKS = 24;

  private final Session session;
  private final Component owner;
  private final Consumer<String> told;

  /**
   * @param owner of dialogs
   * @param told what came of it, for a line
   */
  Interventions(Session session, Component owner, Consumer<String> told) {
    this.session = session;
    this.owner = owner;
    this.told = told;
  }

  /** A fault with what a menu calls it. */
  record Item(String title, String fault) {}

  /** The faults of one robot. */
  static List<Item> faults(RobotId robot) {
    return List.of(
        new Item("Crash", "crash(" + robot + ")"),
        new Item("Crash, restart after 5 s", "crash(" + robot + ",restart=5s)"),
        new Item("Wheels stuck for 5 s", "stuck(" + robot + ",for=5s)"),
        new Item("Wheels at half speed for 10 s", "slow(" + robot + ",0.5,for=10s)"),
        new Item("No position fixes for 5 s", "dropout(" + robot + ",for=5s)"),
        new Item("Positions 100 mm worse for 10 s", "noise(" + robot + ",100mm,3deg,for=10s)"),
        new Item("All that it sends is lost for 5 s", "loss(1,from=" + robot + ",for=5s)"),
        new Item("All sent to it is lost for 5 s", "loss(1,to=" + robot + ",for=5s)"),
        new Item("Something parks before it for 10 s", "block(" + robot + ",for=10s)"));
  }

  /** The faults between two robots. */
  static Item link(RobotId from, RobotId to) {
    return new Item(
        "To " + to + ": all is lost for 10 s", "loss(1,from=" + from + ",to=" + to + ",for=10s)");
  }

  /** For a robot, or for a place on the floor. */
  JPopupMenu menu(@Nullable RobotId robot, Point place) {
    JPopupMenu menu = new JPopupMenu();
    RobotId selected = session.selected();
    if (selected != null) {
      String where = Math.round(place.xMm()) + ", " + Math.round(place.yMm());
      menu.add(item("Send " + selected + " the point " + where, () -> send(selected, place)));
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
      JMenuItem why = new JMenuItem("Only while a run goes on (starl run APP --view)");
      why.setEnabled(false);
      menu.addSeparator();
      menu.add(why);
    }
    return menu;
  }

  private static String lower(String title) {
    return Character.toLowerCase(title.charAt(0)) + title.substring(1);
  }

  private JMenuItem item(String title, Runnable does) {
    JMenuItem item = new JMenuItem(title);
    item.addActionListener(chosen -> does.run());
    item.setEnabled(session.live() != null);
    return item;
  }

  /** Asks for a fault in words. */
  void askFault() {
    if (!isLive()) {
      return;
    }
    RobotId robot = session.selected();
    Object text =
        JOptionPane.showInputDialog(
            owner,
            "A fault, as --fault reads it. What it does not say of times counts from now.",
            "Inject a fault",
            JOptionPane.PLAIN_MESSAGE,
            null,
            null,
            robot == null ? "loss(0.5,for=10s)" : "crash(" + robot + ",restart=5s)");
    if (text != null && !text.toString().isBlank()) {
      inject(text.toString().strip());
    }
  }

  /** Asks for a place in words. */
  void askPoint() {
    RobotId robot = addressee();
    if (robot == null) {
      return;
    }
    Object text =
        JOptionPane.showInputDialog(
            owner,
            "Where is " + robot + " to go? x and y in mm",
            "Send a point",
            JOptionPane.PLAIN_MESSAGE,
            null,
            null,
            "0, 0");
    if (text != null) {
      String[] xy = text.toString().strip().split("[ ,;]+", -1);
      try {
        send(robot, new Point(Double.parseDouble(xy[0]), Double.parseDouble(xy[1])));
      } catch (NumberFormatException | ArrayIndexOutOfBoundsException e) {
        told.accept("'" + text + "': expected two numbers, such as 1500, 700");
      }
    }
  }

  /** Sends the selected robot a place. */
  void sendSelected(Point place) {
    RobotId robot = addressee();
    if (robot != null) {
      send(robot, place);
    }
  }

  /** The robot that would receive a point; if there is none, null and the reason. */
  private @Nullable RobotId addressee() {
    if (!isLive()) {
      return null;
    }
    if (session.selected() == null) {
      told.accept("Select a robot first: click it, or press tab");
    }
    return session.selected();
  }

  private boolean isLive() {
    if (session.live() == null) {
      told.accept("Nothing can be done to a run that is over");
      return false;
    }
    return true;
  }

  void inject(String fault) {
    LiveRun live = session.live();
    if (live != null) {
      try {
        tell(live.fault(fault), fault);
      } catch (BadInput e) {
        told.accept(e.getMessage());
      }
    }
  }

  void send(RobotId robot, Point place) {
    LiveRun live = session.live();
    if (live != null) {
      int x = (int) Math.round(place.xMm());
      int y = (int) Math.round(place.yMm());
      tell(live.point(robot, x, y), robot + " was sent " + x + ", " + y);
    }
  }

  private void tell(CompletableFuture<Long> done, String what) {
    var unused =
        done.whenComplete((atNs, error) -> {
          String line =
              error == null
                  ? "At " + Inspection.seconds(atNs) + ": " + what
                  : String.valueOf(error.getMessage());
          SwingUtilities.invokeLater(() -> told.accept(line));
        });
  }
}
