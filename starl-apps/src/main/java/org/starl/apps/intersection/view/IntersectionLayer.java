package org.starl.apps.intersection.view;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.CrossingFact;
import org.starl.apps.intersection.logic.Trip;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.primitives.mutex.HeldSections;
import org.starl.sim.record.Figures;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Look;
import org.starl.sim.record.Scene;
import org.starl.sim.record.Theme;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;

/** Draws each zone in the colour of the car that holds it, and each car's intended route dotted. */
public final class IntersectionLayer implements Layer {

  private static final String ZONES = "zones";
  private static final String ROUTES = "routes";
  private static final int HELD_ALPHA = 70;

  private final Map<RobotId, Trip> trips;
  private final Participants units;
  private final HeldSections zones;

  /** For a fixed set of cars. */
  public IntersectionLayer(Map<RobotId, Trip> trips) {
    this(trips, Participants.of(), new HeldSections());
  }

  /**
   * For an open road. The cars' routes are read from the trace.
   *
   * @param units the roadside units
   */
  public IntersectionLayer(Participants units) {
    this(Map.of(), units, new HeldSections());
  }

  private IntersectionLayer(Map<RobotId, Trip> trips, Participants units, HeldSections zones) {
    this.trips = new TreeMap<>(trips);
    this.units = units;
    this.zones = zones;
  }

  @Override
  public IntersectionLayer copy() {
    return new IntersectionLayer(trips, units, zones.copy());
  }

  @Override
  public void observe(TraceEvent event) {
    zones.observe(event);
    if (isOpen()) {
      CrossingFact.trip(event)
          .flatMap(CrossingFact.Way::route)
          .ifPresent(route -> trips.put(event.robot(), Crossing.trip(route, 0)));
      if (event instanceof TraceEvent.Left) {
        trips.remove(event.robot());
      }
    }
  }

  private boolean isOpen() {
    return units.size() > 0;
  }

  @Override
  public List<String> parts() {
    return List.of(ZONES, ROUTES);
  }

  @Override
  public void paintFloor(Graphics2D floor, Scene scene, Look look) {
    if (look.shows(ZONES)) {
      areas().forEach((name, area) -> paintZone(floor, name, area, scene, look));
    }
    for (RobotId robot : scene.robots()) {
      Point at = scene.pose(robot).map(Pose::at).orElse(null);
      if (at != null && units.contains(robot)) {
        double sideMm = 2 * scene.radiusMm(robot);
        floor.setColor(look.theme().border());
        floor.fill(
            Figures.rectangle(Rectangle.around(at, sideMm, sideMm))); // a plate under the unit
      } else if (at != null && look.shows(ROUTES)) {
        paintRoute(floor, robot, scene, look);
      }
    }
  }

  @Override
  public SortedMap<String, Rectangle> areas() {
    return Crossing.regions(isOpen() ? Crossing.PLACES : 1);
  }

  @Override
  public List<Point> corners() {
    List<Point> corners = new ArrayList<>();
    trips.values().forEach(trip -> corners.add(trip.exit().at()));
    if (isOpen()) {
      areas().values().forEach(region -> corners.addAll(region.corners()));
    }
    return corners;
  }

  private void paintZone(Graphics2D floor, String name, Rectangle area, Scene scene, Look look) {
    Color colour =
        scene.robots().stream()
            .filter(robot -> zones.held(robot).contains(name))
            .findFirst()
            .map(robot -> Theme.faded(look.robot(scene, robot), HELD_ALPHA))
            .orElse(look.theme().floor());
    floor.setColor(colour);
    floor.fill(Figures.rectangle(area));
    floor.setColor(look.theme().border());
    floor.setStroke(look.line(5));
    floor.draw(Figures.rectangle(area));
    floor.setColor(look.theme().muted());
    Font font = new Font(Font.SANS_SERIF, Font.BOLD, 90);
    Figures.text(floor, name, font, (int) area.xMinMm() + 18, (int) area.yMaxMm() - 92);
  }

  private void paintRoute(Graphics2D floor, RobotId robot, Scene scene, Look look) {
    Trip trip = trips.get(robot);
    if (trip == null || trip.stations().isEmpty()) {
      return;
    }
    List<Point> way = new ArrayList<>(List.of(scene.trail(robot).get(0)));
    trip.stations().forEach(station -> way.add(station.at()));
    way.add(trip.exit().at());
    floor.setColor(look.robot(scene, robot));
    floor.setStroke(look.dots(18, 55));
    floor.draw(Figures.line(way));
  }

  @Override
  public String describe(RobotId robot, Scene scene) {
    if (units.contains(robot)) {
      return "roadside unit";
    }
    Trip trip = trips.get(robot);
    String route = trip == null ? "" : trip.label();
    String location = scene.text(robot, Instance.APP, CrossingFact.LOCATION.name());
    String held = String.join(" ", zones.held(robot));
    return route + "\n" + location + (held.isEmpty() ? "" : ", holds " + held);
  }

  /** Counts each car, and a car in a critical zone ten times. */
  @Override
  public double interest(Scene scene) {
    return scene.robots().stream()
        .flatMap(robot -> scene.pose(robot).stream())
        .mapToDouble(pose -> Crossing.zoneAt(pose.at()).isPresent() ? 10 : 1)
        .sum();
  }
}
