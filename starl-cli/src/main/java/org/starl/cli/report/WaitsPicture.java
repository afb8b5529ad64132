package org.starl.cli.report;

import static org.starl.cli.report.NumberFormats.count;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import org.starl.id.RobotId;
import org.starl.sim.Diagnosis;
import org.starl.sim.UnfinishedRobot;
import org.starl.sim.WaitGraph;

/**
 * A graph of waits as a drawing: the robots on a ring, and an arrow from each robot to those that must
 * act before it goes on. Arrows of a deadlock and its robots are marked.
 */
final class WaitsPicture {

  private static final int MOST_ROBOTS = 24;
  private static final double WIDTH_PX = 480;
  private static final double HEIGHT_PX = 360;
  private static final double MARGIN_PX = 45;
  private static final double NAME_HEIGHT_PX = 26;
  // An arrow ends this far from the middles of its robots.
  private static final double GAP_PX = 30;
  private static final double HEAD_PX = 9;

  private final Html html;
  private final Diagnosis diagnosis;
  private final WaitGraph graph;
  private final List<RobotId> robots;
  private final int left;

  WaitsPicture(Html html, Diagnosis diagnosis) {
    this.html = html;
    this.diagnosis = diagnosis;
    graph = diagnosis.graph();
    Set<RobotId> all = new TreeSet<>();
    // Explained robots first: they are the important ones.
    diagnosis.robots().stream()
        .map(UnfinishedRobot::robot)
        .filter(robot -> isInGraph(robot))
        .forEach(all::add);
    Set<RobotId> others = new TreeSet<>(graph.waits().keySet());
    graph.waits().values().forEach(others::addAll);
    for (RobotId robot : others) {
      if (all.size() < MOST_ROBOTS) {
        all.add(robot);
      }
    }
    others.removeAll(all);
    left = others.size();
    robots = new ArrayList<>(all);
  }

  private boolean isInGraph(RobotId robot) {
    return !graph.of(robot).isEmpty() || graph.waiters(robot) > 0;
  }

  /** Writes the drawing; nothing if no robot waits for another. */
  void write() {
    if (robots.isEmpty()) {
      return;
    }
    html.open("figure", "class", "waits");
    String box = "0 0 " + number(WIDTH_PX) + " " + number(HEIGHT_PX);
    html.open("svg", "viewBox", box, "role", "img", "aria-label", "Which robot waits for which");
    html.element("title", "Which robot waits for which");
    for (RobotId from : robots) {
      graph.of(from).stream().filter(robots::contains).forEach(to -> arrow(from, to));
    }
    robots.forEach(this::name);
    html.close();
    String caption = "An arrow points to the robot that must act first.";
    if (robots.stream().anyMatch(robot -> graph.leads(robot, robot))) {
      caption += " Red: robots that wait for each other in a circle.";
    }
    if (robots.stream().anyMatch(diagnosis.down()::contains)) {
      caption += " Dashed: crashed.";
    }
    if (left > 0) {
      caption += " Not shown: " + count(left, "robot") + ".";
    }
    html.element("figcaption", caption).close();
  }

  private void arrow(RobotId from, RobotId to) {
    double dx = x(to) - x(from);
    double dy = y(to) - y(from);
    double length = StrictMath.hypot(dx, dy);
    double ux = dx / length;
    double uy = dy / length;
    // Two arrows between the same robots lie side by side.
    double aside = graph.of(to).contains(from) ? 5 : 0;
    double beginX = x(from) + ux * GAP_PX - uy * aside;
    double beginY = y(from) + uy * GAP_PX + ux * aside;
    double endX = x(to) - ux * GAP_PX - uy * aside;
    double endY = y(to) - uy * GAP_PX + ux * aside;
    String shaft = "M" + at(beginX, beginY) + "L" + at(endX, endY);
    double neckX = endX - ux * HEAD_PX;
    double neckY = endY - uy * HEAD_PX;
    String head =
        "M%sL%sL%s"
            .formatted(
                at(neckX - uy * HEAD_PX / 2, neckY + ux * HEAD_PX / 2),
                at(endX, endY),
                at(neckX + uy * HEAD_PX / 2, neckY - ux * HEAD_PX / 2));
    html.open("path", "d", shaft + head, "class", graph.leads(to, from) ? "wait circle" : "wait");
    html.element("title", from + " waits for " + to).close();
  }

  private void name(RobotId robot) {
    String cssClass = graph.leads(robot, robot) ? "robot circle" : "robot";
    double width = 14 + 9.0 * robot.name().length();
    html.empty(
        "rect",
        "x",
        number(x(robot) - width / 2),
        "y",
        number(y(robot) - NAME_HEIGHT_PX / 2),
        "width",
        number(width),
        "height",
        number(NAME_HEIGHT_PX),
        "rx",
        "6",
        "class",
        diagnosis.down().contains(robot) ? cssClass + " down" : cssClass);
    html.element(
        "text",
        robot.name(),
        "x",
        number(x(robot)),
        "y",
        number(y(robot) + 5),
        "text-anchor",
        "middle");
  }

  private double x(RobotId robot) {
    return WIDTH_PX / 2 + (WIDTH_PX / 2 - MARGIN_PX) * StrictMath.sin(angleRad(robot));
  }

  private double y(RobotId robot) {
    return HEIGHT_PX / 2 - (HEIGHT_PX / 2 - MARGIN_PX) * StrictMath.cos(angleRad(robot));
  }

  private double angleRad(RobotId robot) {
    return 2 * Math.PI * robots.indexOf(robot) / robots.size();
  }

  private static String at(double x, double y) {
    return number(x) + "," + number(y);
  }

  private static String number(double px) {
    return String.format(Locale.ROOT, "%.1f", px);
  }
}
