package org.starl.apps.search.view;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.apps.search.logic.Grid;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.Room;
import org.starl.apps.search.logic.SearchTrace;
import org.starl.apps.search.spec.TrueView;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Look;
import org.starl.sim.record.Scene;
import org.starl.sim.record.Theme;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;

/**
 * Draws rooms with their names, what was seen of them in the colour of who has the room, each sweep's
 * legs dotted, the things to find, and a crown on the leader.
 */
public final class SearchLayer implements Layer {

  private static final String ROOMS = "rooms";
  private static final String SWEEPS = "sweeps";
  private static final String THINGS = "things";
  private static final String LEADER = "leader";
  private static final int SEEN_ALPHA = 70;
  private static final double THING_MM = 110;

  private final House house;
  private final List<ItemPosition> things;
  private final TrueView view;
  private final SortedMap<String, RobotId> searchers = new TreeMap<>();
  private final SortedMap<String, String> sweeps = new TreeMap<>();
  private final SortedMap<RobotId, String> rooms = new TreeMap<>();
  private final SortedSet<String> done = new TreeSet<>();
  private final SortedMap<RobotId, String> ends = new TreeMap<>();
  private final SortedSet<RobotId> down = new TreeSet<>();

  public SearchLayer(House house, List<ItemPosition> things) {
    this(house, things, new TrueView(house));
  }

  private SearchLayer(House house, List<ItemPosition> things, TrueView view) {
    this.house = house;
    this.things = List.copyOf(things);
    this.view = view;
  }

  @Override
  public SearchLayer copy() {
    SearchLayer copy = new SearchLayer(house, things, view.copy());
    copy.searchers.putAll(searchers);
    copy.sweeps.putAll(sweeps);
    copy.rooms.putAll(rooms);
    copy.done.addAll(done);
    copy.ends.putAll(ends);
    copy.down.addAll(down);
    return copy;
  }

  @Override
  public void observe(TraceEvent event) {
    view.observe(event);
    if (event instanceof Variable variable
        && variable.source().equals(SearchTrace.SOURCE)
        && variable.name().equals(SearchTrace.ROOM)) {
      tookRoom(variable.robot(), variable.value());
    } else if (event instanceof Action action && action.source().equals(SearchTrace.SOURCE)) {
      if (action.name().equals(SearchTrace.SWEPT)) {
        done.add(action.args().get(0));
      } else if (action.name().equals(SearchTrace.SWEEP)) {
        sweeps.putIfAbsent(action.args().get(0), action.args().get(1));
      } else if (action.name().equals(SearchTrace.ANSWER)) {
        ends.put(action.robot(), action.args().get(0));
      }
    } else if (event instanceof Fault fault) {
      if (fault.name().equals(Fault.CRASH)) {
        down.add(fault.robot());
      } else if (fault.name().equals(Fault.RESTART)) {
        down.remove(fault.robot());
      }
    }
  }

  /** A room that was given up is drawn as one that nobody has gone to. */
  private void tookRoom(RobotId robot, String room) {
    String before = rooms.getOrDefault(robot, "");
    if (!done.contains(before)) {
      sweeps.remove(before);
    }
    rooms.put(robot, room);
    if (!room.isEmpty()) {
      searchers.put(room, robot);
      sweeps.remove(room);
    }
  }

  @Override
  public List<String> parts() {
    return List.of(ROOMS, SWEEPS, THINGS, LEADER);
  }

  @Override
  public void paintFloor(Graphics2D floor, Scene scene, Look look) {
    for (Room room : look.shows(ROOMS) ? house.rooms() : List.<Room>of()) {
      paintRoom(floor, room, scene, look);
    }
    for (Map.Entry<String, String> sweep : sweeps.entrySet()) {
      RobotId robot = searchers.get(sweep.getKey());
      if (robot != null && look.shows(SWEEPS)) {
        paintSweep(floor, sweep.getValue(), look.robot(scene, robot), look);
      }
    }
    for (ItemPosition thing : look.shows(THINGS) ? things : List.<ItemPosition>of()) {
      paintThing(floor, thing.at(), look);
    }
    for (RobotId robot : scene.robots()) {
      if (look.shows(LEADER) && isLeader(robot, scene) && scene.pose(robot).isPresent()) {
        paintCrown(floor, scene.pose(robot).get().at(), scene.radiusMm(robot), look);
      }
    }
  }

  @Override
  public List<Point> corners() {
    return List.of(
        new Point(house.bounds().xMinMm(), house.bounds().yMinMm()),
        new Point(house.bounds().xMaxMm(), house.bounds().yMaxMm()));
  }

  private void paintRoom(Graphics2D floor, Room room, Scene scene, Look look) {
    RobotId robot = searchers.get(room.name());
    Color seen = look.theme().floor();
    if (robot != null) {
      seen = Theme.faded(look.robot(scene, robot), SEEN_ALPHA);
    }
    Strips strips = new Strips(floor, house.grid(), seen, look.theme().shade());
    // Smoothed edges of strips side by side would show as lines.
    Object before = floor.getRenderingHint(RenderingHints.KEY_ANTIALIASING);
    floor.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_OFF);
    room.forEachCell(strips);
    strips.flush();
    floor.setRenderingHint(RenderingHints.KEY_ANTIALIASING, before);
    write(floor, room.name(), room.rest(), 360, look);
  }

  /** Cells side by side are painted as one, lest their seams show. */
  private final class Strips implements Grid.Visitor {
    private final Graphics2D floor;
    private final Grid grid;
    private final Color seen;
    private final Color unseen;
    private int first = -1;
    private int last = -1;
    private boolean isSeen;

    Strips(Graphics2D floor, Grid grid, Color seen, Color unseen) {
      this.floor = floor;
      this.grid = grid;
      this.seen = seen;
      this.unseen = unseen;
    }

    @Override
    public void visit(int cell) {
      boolean goesOn =
          first >= 0
              && cell == last + 1
              && cell % grid.columns() != 0
              && view.wasSeen(cell) == isSeen;
      if (!goesOn) {
        flush();
        first = cell;
        isSeen = view.wasSeen(cell);
      }
      last = cell;
    }

    void flush() {
      if (first >= 0) {
        double half = grid.cellMm() / 2.0;
        floor.setColor(isSeen ? seen : unseen);
        floor.fill(
            new Rectangle2D.Double(
                grid.centreX(first) - half,
                grid.centreY(first) - half,
                (last - first + 1.0) * grid.cellMm(),
                grid.cellMm()));
      }
      first = -1;
    }
  }

  private static void write(Graphics2D floor, String text, Point at, int sizeMm, Look look) {
    Graphics2D upright = (Graphics2D) floor.create();
    upright.transform(AffineTransform.getScaleInstance(1, -1));
    upright.setFont(new Font(Font.SANS_SERIF, Font.BOLD, sizeMm));
    upright.setColor(look.theme().muted());
    int half = upright.getFontMetrics().stringWidth(text) / 2;
    upright.drawString(text, (int) at.xMm() - half, (int) -at.yMm() + sizeMm / 3);
    upright.dispose();
  }

  /** A list of legs as text: {@code [500,1500>900,1500, 700,700]}. */
  private void paintSweep(Graphics2D floor, String legs, Color colour, Look look) {
    Path2D path = new Path2D.Double();
    Point last = null;
    for (Point point : points(legs)) {
      // From one leg to the next it finds its way; where that is straight it is drawn.
      if (last == null || !house.sight().sees(last, point)) {
        path.moveTo(point.xMm(), point.yMm());
      } else {
        path.lineTo(point.xMm(), point.yMm());
      }
      last = point;
    }
    floor.setColor(look.theme().edge(colour));
    floor.setStroke(look.dots(30, 90));
    floor.draw(path);
  }

  private static List<Point> points(String legs) {
    List<Point> points = new ArrayList<>();
    for (String leg : legs.substring(1, legs.length() - 1).split(", ", -1)) {
      for (String end : leg.isEmpty() ? new String[0] : leg.split(">", -1)) {
        int comma = end.indexOf(',');
        points.add(
            new Point(
                Integer.parseInt(end.substring(0, comma)),
                Integer.parseInt(end.substring(comma + 1))));
      }
    }
    return points;
  }

  private void paintThing(Graphics2D floor, Point at, Look look) {
    floor.setColor(look.theme().alarm());
    Path2D star = new Path2D.Double();
    for (int i = 0; i < 10; i++) {
      double radius = i % 2 == 0 ? THING_MM * 1.8 : THING_MM * 0.75;
      double angle = StrictMath.PI * (0.5 + i / 5.0);
      double x = at.xMm() + radius * StrictMath.cos(angle);
      double y = at.yMm() + radius * StrictMath.sin(angle);
      if (i == 0) {
        star.moveTo(x, y);
      } else {
        star.lineTo(x, y);
      }
    }
    star.closePath();
    floor.fill(star);
    floor.setStroke(look.line(12));
    double range = house.rangeMm();
    floor.draw(new Ellipse2D.Double(at.xMm() - range, at.yMm() - range, 2 * range, 2 * range));
  }

  private boolean isLeader(RobotId robot, Scene scene) {
    return !down.contains(robot)
        && !scene.variable(robot, SearchTrace.SOURCE, SearchTrace.DUTY).isEmpty();
  }

  private static void paintCrown(Graphics2D floor, Point at, double radiusMm, Look look) {
    double base = at.yMm() + radiusMm + 20;
    double half = radiusMm * 0.85;
    double high = radiusMm * 1.1;
    Path2D crown = new Path2D.Double();
    crown.moveTo(at.xMm() - half, base);
    crown.lineTo(at.xMm() - half, base + high);
    crown.lineTo(at.xMm() - half / 2, base + high / 2);
    crown.lineTo(at.xMm(), base + high);
    crown.lineTo(at.xMm() + half / 2, base + high / 2);
    crown.lineTo(at.xMm() + half, base + high);
    crown.lineTo(at.xMm() + half, base);
    crown.closePath();
    floor.setColor(look.theme().gold());
    floor.fill(crown);
    floor.setColor(look.theme().edge(look.theme().gold()));
    floor.setStroke(look.line(14));
    floor.draw(crown);
  }

  @Override
  public String describe(RobotId robot, Scene scene) {
    if (down.contains(robot)) {
      return "crashed";
    }
    String room = scene.variable(robot, SearchTrace.SOURCE, SearchTrace.ROOM);
    String location = scene.variable(robot, SearchTrace.SOURCE, SearchTrace.LOCATION);
    String what =
        switch (location) {
          case "ELECT" -> "elects a leader";
          case "WAIT" -> "waits for a room";
          case "GO" -> "goes to room " + room;
          case "SWEEP" -> "sweeps room " + room;
          case "ANSWER" -> "agrees on the answer";
          default -> ends.getOrDefault(robot, location);
        };
    return what + (isLeader(robot, scene) ? "\nleads (crown): assigns the rooms" : "");
  }

  @Override
  public double interest(Scene scene) {
    double interest = 0;
    for (RobotId robot : scene.robots()) {
      String location = scene.variable(robot, SearchTrace.SOURCE, SearchTrace.LOCATION);
      interest += location.equals("SWEEP") ? 2 : location.equals("GO") ? 1 : 0;
    }
    return interest;
  }
}
