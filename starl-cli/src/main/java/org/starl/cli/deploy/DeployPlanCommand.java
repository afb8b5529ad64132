package org.starl.cli.deploy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.OutputFile;
import org.starl.cli.deploy.FloorSheet.Ink;
import org.starl.cli.request.DeployedApp;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.launch.DeploymentFile;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.Positions;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.SimulationPlan;
import org.starl.spec.Bodies;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Moved;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code starl deploy plan}. */
@Command(
    name = "plan",
    description =
        "Prints the floor to tape for a deployment, in mm: its size, the starts and headings of the"
            + " robots, where they end, marked areas, obstacles, and the axes. Starts and ends are those"
            + " of a simulated run with the deployment's limits and errors.",
    footer = {"", "Example: starl deploy plan crossing.yaml --svg floor.svg"})
final class DeployPlanCommand extends BaseCommand implements Callable<Integer> {

  /** Beside the outermost bodies of the simulated run: real ones are less exact. */
  private static final double ROOM_MM = 200;

  private static final double MARGIN_MM = 500;
  private static final double GRID_MM = 1000;
  private static final double AXIS_MM = 300;

  @Parameters(index = "0", paramLabel = "FILE", description = "A deployment file.")
  private String file = "";

  @Option(
      names = "--svg",
      paramLabel = "FILE",
      description = "Write the floor to FILE, in true size: one unit is one mm.")
  private @Nullable String svg;

  @Option(
      names = "--pdf",
      paramLabel = "FILE",
      description = "Write the floor to FILE, as one page of A4; the page names its scale.")
  private @Nullable String pdf;

  @Override
  public Integer call() throws IOException {
    Deployment deployment = DeploymentFile.read(file);
    DeployedApp app = DeployedApp.of(deployment, demos());
    SimulationPlan plan = app.plan();
    Watch watch = new Watch();
    List<String> problems = app.rehearse(plan.endNs(), watch);
    if (!problems.isEmpty()) {
      throw new BadInput(problems.get(0));
    }
    SortedMap<String, Rectangle> areas = app.areas();
    Rectangle floor = floor(plan, watch, areas);
    lines(deployment, plan, watch, areas, floor).forEach(out()::println);
    FloorSheet sheet = sheet(deployment, plan, watch, areas, floor);
    if (svg != null) {
      write("--svg", svg, sheet.svg().getBytes(StandardCharsets.UTF_8));
    }
    if (pdf != null) {
      write("--pdf", pdf, sheet.pdf());
    }
    return ExitStatus.GOOD;
  }

  private void write(String option, String name, byte[] content) throws IOException {
    try (OutputFile output = new OutputFile(option, name)) {
      output.stream().write(content);
    }
    out().println("written: " + name);
  }

  /** Where bodies are during a run, and at their ends. */
  private static final class Watch implements SimObserver {
    private final Bodies bodies = new Bodies();
    private final SortedMap<RobotId, Pose> ends = new TreeMap<>();
    private final List<Point> extent = new ArrayList<>();

    @Override
    public void observed(TraceEvent event) {
      if (event instanceof Left || event instanceof Moved) {
        note(event.robot(), event.timeNs());
      }
      bodies.observe(event);
      if (event instanceof Joined) {
        note(event.robot(), event.timeNs());
      }
    }

    @Override
    public void finished(SimResult result) {
      bodies.robots().forEach(robot -> note(robot, result.endNs()));
    }

    /** The robots that end where a body at this pose would touch them, in the order of their names. */
    List<RobotId> endingAt(Pose pose, double radiusMm) {
      return ends.entrySet().stream()
          .filter(end -> end.getValue().at().distanceMm(pose.at()) < 2 * radiusMm)
          .map(Map.Entry::getKey)
          .toList();
    }

    private void note(RobotId robot, long timeNs) {
      if (bodies.isOnFloor(robot)) {
        Pose pose = bodies.poseAt(robot, timeNs);
        double sideMm = 2 * bodies.radiusMm(robot);
        ends.put(robot, pose);
        extent.addAll(Rectangle.around(pose.at(), sideMm, sideMm).corners());
        List<Point> corners = Rectangle.around(extent).corners();
        extent.clear();
        extent.addAll(corners);
      }
    }
  }

  private static Rectangle floor(
      SimulationPlan plan, Watch watch, SortedMap<String, Rectangle> areas) {
    List<Point> points = new ArrayList<>();
    if (!watch.extent.isEmpty()) {
      points.addAll(Rectangle.around(watch.extent).widened(ROOM_MM).corners());
    }
    plan.robots().forEach(robot -> points.add(robot.start().at()));
    areas.values().forEach(area -> points.addAll(area.corners()));
    plan.obstacles().known().all().forEach(obstacle -> points.addAll(obstacle.points()));
    plan.waypoints().forEach(waypoint -> points.add(waypoint.at()));
    Rectangle all = Rectangle.around(points);
    return new Rectangle(
        StrictMath.floor(all.xMinMm()),
        StrictMath.floor(all.yMinMm()),
        StrictMath.ceil(all.xMaxMm()),
        StrictMath.ceil(all.yMaxMm()));
  }

  private static List<String> lines(
      Deployment deployment,
      SimulationPlan plan,
      Watch watch,
      Map<String, Rectangle> areas,
      Rectangle floor) {
    List<String> lines = new ArrayList<>();
    lines.add("floor: " + size(floor) + " mm, " + sides(floor));
    lines.add(Axes.of(deployment.positions()).line());
    for (RobotSpec robot : plan.robots()) {
      Pose end = watch.ends.get(robot.id());
      lines.add(
          "%s: starts at %s, radius %.0f mm; ends at %s"
              .formatted(
                  robot.id(),
                  pose(robot.start()),
                  plan.settings().robotRadiusMm(),
                  end == null ? "no place" : pose(end)));
    }
    watch.ends.forEach((robot, end) -> {
      List<RobotId> sharing = watch.endingAt(end, plan.settings().robotRadiusMm());
      if (sharing.size() > 1 && sharing.get(0).equals(robot)) {
        lines.add(sharing + " end at one place: lift each off the floor when it has ended");
      }
    });
    areas.forEach((name, area) -> lines.add("area " + name + ": " + sides(area)));
    for (ItemPosition waypoint : plan.waypoints()) {
      lines.add("waypoint " + waypoint.name() + ": " + pose(waypoint.pose()));
    }
    for (Obstacle obstacle : plan.obstacles().known().all()) {
      List<String> corners =
          obstacle.points().stream().map(point -> mm(point.xMm()) + "," + mm(point.yMm())).toList();
      lines.add("obstacle: " + String.join(" ", corners) + (obstacle.closed() ? " closed" : ""));
    }
    return lines;
  }

  private static String size(Rectangle area) {
    return mm(area.xMaxMm() - area.xMinMm()) + " by " + mm(area.yMaxMm() - area.yMinMm());
  }

  private static String sides(Rectangle area) {
    return "x from %s to %s, y from %s to %s"
        .formatted(mm(area.xMinMm()), mm(area.xMaxMm()), mm(area.yMinMm()), mm(area.yMaxMm()));
  }

  private static String pose(Pose pose) {
    return "x %s y %s mm, heading %s deg".formatted(mm(pose.xMm()), mm(pose.yMm()), degrees(pose));
  }

  private static String degrees(Pose pose) {
    return mm(StrictMath.toDegrees(pose.headingRad()));
  }

  private static String mm(double value) {
    return String.format(Locale.ROOT, "%.0f", value + 0.0).replaceAll("^-0$", "0");
  }

  /**
   * The floor's axes in the words of the system that measures positions.
   *
   * @param owner whose origin and axes they are
   * @param y the owner's name of the floor's y
   */
  private record Axes(String owner, String y) {

    static Axes of(Positions positions) {
      return switch (positions) {
        case Positions.NatNet cameras -> new Axes("the cameras", cameras.isYUp() ? "-z" : "y");
        case Positions.JsonFeed lines -> new Axes("the lines of JSON", "y");
        case Positions.Ros2 poses -> new Axes("the ROS frame " + poses.frame(), "y");
      };
    }

    String line() {
      return "origin and axes: those of %s, where y is called %s; headings counter-clockwise from x"
          .formatted(owner, y);
    }
  }

  private static FloorSheet sheet(
      Deployment deployment,
      SimulationPlan plan,
      Watch watch,
      Map<String, Rectangle> areas,
      Rectangle floor) {
    Point origin = new Point(0, 0);
    List<Point> corners = new ArrayList<>(floor.corners());
    corners.add(origin);
    FloorSheet sheet = new FloorSheet(Rectangle.around(corners).widened(MARGIN_MM));
    grid(sheet, floor);
    Axes axes = Axes.of(deployment.positions());
    sheet.arrow(Ink.BODY, origin, 0, AXIS_MM);
    sheet.arrow(Ink.BODY, origin, StrictMath.PI / 2, AXIS_MM);
    sheet.text(Ink.BODY, new Point(AXIS_MM + 10, -25), "x, origin 0,0 of " + axes.owner());
    sheet.text(
        Ink.BODY,
        new Point(-25, AXIS_MM + 20),
        axes.y().equals("y") ? "y" : "y, called " + axes.y() + " there");
    for (Map.Entry<String, Rectangle> area : areas.entrySet()) {
      Rectangle at = area.getValue();
      sheet.outline(Ink.TAPE, at.corners());
      sheet.text(
          Ink.TAPE, new Point(at.xMinMm() + 20, at.yMaxMm() - FloorSheet.TEXT_MM), area.getKey());
    }
    for (Obstacle obstacle : plan.obstacles().known().all()) {
      obstacle.sides().forEach(side -> sheet.line(Ink.BODY, side.from(), side.to()));
    }
    for (ItemPosition waypoint : plan.waypoints()) {
      sheet.circle(Ink.TAPE, waypoint.at(), 20);
      sheet.text(Ink.TAPE, waypoint.at().plus(new Point(30, 0)), waypoint.name());
    }
    double radiusMm = plan.settings().robotRadiusMm();
    Point beside = new Point(radiusMm + 20, 10);
    Point below = new Point(0, -FloorSheet.TEXT_MM);
    for (RobotSpec robot : plan.robots()) {
      Pose start = robot.start();
      body(sheet, Ink.TAPE, start, radiusMm);
      sheet.text(Ink.TAPE, start.at().plus(beside), robot.id().name());
      sheet.text(
          Ink.TAPE,
          start.at().plus(beside).plus(below),
          "%s,%s %s deg".formatted(mm(start.xMm()), mm(start.yMm()), degrees(start)));
      Pose end = watch.ends.get(robot.id());
      if (end != null) {
        body(sheet, Ink.HELP, end, radiusMm);
        int line = watch.endingAt(end, radiusMm).indexOf(robot.id());
        sheet.text(Ink.HELP, end.at().plus(beside).plus(below.times(line)), robot.id() + " ends");
      }
    }
    return sheet;
  }

  private static void body(FloorSheet sheet, Ink ink, Pose pose, double radiusMm) {
    sheet.circle(ink, pose.at(), radiusMm);
    sheet.arrow(ink, pose.at(), pose.headingRad(), radiusMm);
  }

  /** The floor's edge with its sizes, and a measure each metre. */
  private static void grid(FloorSheet sheet, Rectangle floor) {
    sheet.outline(Ink.HELP, floor.corners());
    sheet.text(
        Ink.HELP,
        new Point(floor.xMinMm(), floor.yMaxMm() + 1.5 * FloorSheet.TEXT_MM),
        "floor " + size(floor) + " mm");
    for (double x = StrictMath.ceil(floor.xMinMm() / GRID_MM) * GRID_MM;
        x <= floor.xMaxMm();
        x += GRID_MM) {
      Point foot = new Point(x, floor.yMinMm());
      sheet.line(Ink.HELP, foot, foot.minus(new Point(0, FloorSheet.TEXT_MM)));
      sheet.text(Ink.HELP, foot.minus(new Point(0, 2 * FloorSheet.TEXT_MM)), "x " + mm(x));
    }
    for (double y = StrictMath.ceil(floor.yMinMm() / GRID_MM) * GRID_MM;
        y <= floor.yMaxMm();
        y += GRID_MM) {
      Point foot = new Point(floor.xMinMm(), y);
      sheet.line(Ink.HELP, foot, foot.minus(new Point(FloorSheet.TEXT_MM, 0)));
      sheet.text(Ink.HELP, foot.minus(new Point(MARGIN_MM - 20, 0)), "y " + mm(y));
    }
  }
}
