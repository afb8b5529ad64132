package org.starl.apps.search.view;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.BitSet;
import java.util.List;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.apps.search.logic.Answer;
import org.starl.apps.search.logic.Grid;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.Room;
import org.starl.apps.search.logic.SearchApp.Location;
import org.starl.apps.search.logic.SearchFact;
import org.starl.apps.search.spec.TrueView;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.sim.record.Figures;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Look;
import org.starl.sim.record.Scene;
import org.starl.sim.record.Theme;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;

/**
 * Draws the rooms with their names, the floor that was seen in the colour of the robot that has the
 * room, the legs of each sweep dotted, the things to find, and a crown on the leader.
 */
public final class SearchLayer implements Layer {

  private static final String ROOMS = "rooms";
  private static final String SWEEPS = "sweeps";
  private static final String THINGS = "things";
  private static final String LEADER = "leader";
  private static final int SEEN_ALPHA = 70;
  private static final int NAME_MM = 360;
  private static final double THING_MM = 110;

  private final House house;
  private final List<ItemPosition> things;
  private final TrueView view;
  private final SortedMap<String, RobotId> searchers = new TreeMap<>();
  private final SortedMap<String, List<SearchFact.Leg>> sweeps = new TreeMap<>();
  private final SortedMap<RobotId, String> rooms = new TreeMap<>();
  private final SortedSet<String> done = new TreeSet<>();
  private final SortedMap<RobotId, Answer> ends = new TreeMap<>();
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
    switch (event) {
      case Variable variable -> {
        String room = variable.of(SearchFact.ROOM);
        if (room != null) {
          tookRoom(variable.robot(), room);
        }
      }
      case Action action when action.fact() instanceof SearchFact fact ->
          acted(action.robot(), fact);
      case Fault fault when fault.name().equals(Fault.CRASH) -> down.add(fault.robot());
      case Fault fault when fault.name().equals(Fault.RESTART) -> down.remove(fault.robot());
      default -> {
        // Changes nothing in the picture.
      }
    }
  }

  private void acted(RobotId robot, SearchFact fact) {
    switch (fact) {
      case SearchFact.Swept swept -> done.add(swept.room());
      case SearchFact.Planned planned -> sweeps.putIfAbsent(planned.room(), planned.legs());
      case SearchFact.Ended ended -> ends.put(robot, ended.answer());
      case SearchFact.Found found -> {
        // The things are drawn from the start.
      }
    }
  }

  /** Notes the robot's new room; the sweep of a room that it has given up is not drawn any more. */
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
  public List<Point> corners() {
    return house.bounds().corners();
  }

  @Override
  public void paintFloor(Graphics2D floor, Scene scene, Look look) {
    if (look.shows(ROOMS)) {
      house.rooms().forEach(room -> paintRoom(floor, room, scene, look));
    }
    if (look.shows(SWEEPS)) {
      sweeps.forEach((room, legs) -> {
        RobotId robot = searchers.get(room);
        if (robot != null) {
          paintSweep(floor, legs, look.robot(scene, robot), look);
        }
      });
    }
    if (look.shows(THINGS)) {
      things.forEach(thing -> paintThing(floor, thing.at(), look));
    }
    for (RobotId robot : scene.robots()) {
      if (look.shows(LEADER) && isLeader(robot, scene) && scene.pose(robot).isPresent()) {
        paintCrown(floor, scene.pose(robot).get().at(), scene.radiusMm(robot), look);
      }
    }
  }

  private void paintRoom(Graphics2D floor, Room room, Scene scene, Look look) {
    RobotId robot = searchers.get(room.name());
    Color colour =
        robot == null ? look.theme().floor() : Theme.faded(look.robot(scene, robot), SEEN_ALPHA);
    BitSet seen = view.seen(room);
    BitSet unseen = (BitSet) room.cells().clone();
    unseen.andNot(seen);
    paintCells(floor, seen, colour);
    paintCells(floor, unseen, look.theme().shade());
    Font font = new Font(Font.SANS_SERIF, Font.BOLD, NAME_MM);
    floor.setColor(look.theme().muted());
    int half = floor.getFontMetrics(font).stringWidth(room.name()) / 2;
    int x = (int) room.rest().xMm() - half;
    Figures.text(floor, room.name(), font, x, (int) room.rest().yMm() - NAME_MM / 3);
  }

  /**
   * Paints the cells of a row that are side by side as one, and edges unsmoothed: no seams show.
   */
  private void paintCells(Graphics2D floor, BitSet cells, Color colour) {
    Object before = floor.getRenderingHint(RenderingHints.KEY_ANTIALIASING);
    floor.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_OFF);
    floor.setColor(colour);
    Grid grid = house.grid();
    int end;
    for (int first = cells.nextSetBit(0); first >= 0; first = cells.nextSetBit(end)) {
      int nextRow = (first / grid.columns() + 1) * grid.columns();
      end = Math.min(cells.nextClearBit(first), nextRow);
      Point centre = grid.centre(first);
      double half = grid.cellMm() / 2.0;
      double widthMm = (double) (end - first) * grid.cellMm();
      floor.fill(
          new Rectangle2D.Double(centre.xMm() - half, centre.yMm() - half, widthMm, grid.cellMm()));
    }
    floor.setRenderingHint(RenderingHints.KEY_ANTIALIASING, before);
  }

  /** Paints the legs, and the straight ways between them where nothing is in the way. */
  private void paintSweep(Graphics2D floor, List<SearchFact.Leg> legs, Color colour, Look look) {
    Path2D path = new Path2D.Double();
    Point last = null;
    for (SearchFact.Leg leg : legs) {
      boolean isStop = leg.from().equals(leg.to());
      for (Point point : isStop ? List.of(leg.to()) : List.of(leg.from(), leg.to())) {
        if (last == null || !house.sight().sees(last, point)) {
          path.moveTo(point.xMm(), point.yMm());
        } else {
          path.lineTo(point.xMm(), point.yMm());
        }
        last = point;
      }
    }
    floor.setColor(look.theme().edge(colour));
    floor.setStroke(look.dots(30, 90));
    floor.draw(path);
  }

  private void paintThing(Graphics2D floor, Point at, Look look) {
    double[] star = new double[20];
    for (int i = 0; i < 10; i++) {
      double radius = i % 2 == 0 ? THING_MM * 1.8 : THING_MM * 0.75;
      double angle = StrictMath.PI * (0.5 + i / 5.0);
      star[2 * i] = at.xMm() + radius * StrictMath.cos(angle);
      star[2 * i + 1] = at.yMm() + radius * StrictMath.sin(angle);
    }
    floor.setColor(look.theme().alarm());
    floor.fill(Figures.polygon(star));
    floor.setStroke(look.line(12));
    floor.draw(Figures.disc(at, house.rangeMm()));
  }

  private static void paintCrown(Graphics2D floor, Point at, double radiusMm, Look look) {
    double x = at.xMm();
    double half = radiusMm * 0.85;
    double base = at.yMm() + radiusMm + 20;
    double top = base + radiusMm * 1.1;
    double notch = base + radiusMm * 0.55;
    Path2D crown =
        Figures.polygon(
            x - half,
            base,
            x - half,
            top,
            x - half / 2,
            notch,
            x,
            top,
            x + half / 2,
            notch,
            x + half,
            top,
            x + half,
            base);
    floor.setColor(look.theme().gold());
    floor.fill(crown);
    floor.setColor(look.theme().edge(look.theme().gold()));
    floor.setStroke(look.line(14));
    floor.draw(crown);
  }

  private boolean isLeader(RobotId robot, Scene scene) {
    SearchFact.Assigned duty = scene.variable(robot, SearchFact.DUTY);
    return !down.contains(robot) && duty != null && duty.isLeading();
  }

  @Override
  public String describe(RobotId robot, Scene scene) {
    if (down.contains(robot)) {
      return "crashed";
    }
    Location location = scene.variable(robot, SearchFact.LOCATION);
    String what = location == null ? "" : doing(robot, location, scene);
    return what + (isLeader(robot, scene) ? "\nleads (crown): assigns the rooms" : "");
  }

  private String doing(RobotId robot, Location location, Scene scene) {
    String room = scene.text(robot, Instance.APP, SearchFact.ROOM.name());
    return switch (location) {
      case ELECT -> "elects a leader";
      case WAIT -> "waits for a room";
      case GO -> "drives to room " + room;
      case SWEEP -> "sweeps room " + room;
      case ANSWER -> "agrees on the answer";
      case DONE -> {
        Answer end = ends.get(robot);
        yield end == null ? location.name() : end.toString();
      }
    };
  }

  @Override
  public double interest(Scene scene) {
    double interest = 0;
    for (RobotId robot : scene.robots()) {
      Location location = scene.variable(robot, SearchFact.LOCATION);
      interest += location == Location.SWEEP ? 2 : location == Location.GO ? 1 : 0;
    }
    return interest;
  }
}
