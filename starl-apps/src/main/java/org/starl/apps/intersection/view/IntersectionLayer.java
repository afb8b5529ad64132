package org.starl.apps.intersection.view;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.RobotId;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.IntersectionApp;
import org.starl.apps.intersection.logic.Trip;
import org.starl.apps.intersection.logic.Zone;
import org.starl.apps.intersection.spec.HeldZones;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Painter;
import org.starl.sim.record.Scene;
import org.starl.trace.TraceEvent;

/** Draws zones in the colour of who holds them, and each car's intended route dotted. */
public final class IntersectionLayer implements Layer {

  private static final Color FREE = new Color(0xEC, 0xEC, 0xE6);
  private static final Color BORDER = new Color(0x99, 0x99, 0x90);
  private static final int HELD_ALPHA = 70;
  private static final float[] DOTS = {1, 55};

  private final Crossing crossing;
  private final SortedMap<RobotId, Trip> trips;
  private final HeldZones zones = new HeldZones();

  public IntersectionLayer(Crossing crossing, Map<RobotId, Trip> trips) {
    this.crossing = crossing;
    this.trips = new TreeMap<>(trips);
  }

  @Override
  public void observe(TraceEvent event) {
    zones.observe(event);
  }

  @Override
  public void paintFloor(Graphics2D floor, Scene scene) {
    for (Map.Entry<String, Region> zone : crossing.regions().entrySet()) {
      paintZone(floor, zone.getKey(), (Rectangle) zone.getValue(), holder(zone.getKey(), scene));
    }
    for (Zone zone : Zone.values()) {
      paintZone(floor, zone + "0", (Rectangle) crossing.arrivalRegion(zone), FREE);
    }
    List<RobotId> robots = scene.robots();
    for (int i = 0; i < robots.size(); i++) {
      if (scene.pose(robots.get(i)).isPresent()) {
        paintRoute(floor, robots.get(i), scene, Painter.colour(i));
      }
    }
  }

  @Override
  public List<Point> corners() {
    List<Point> ends = new ArrayList<>();
    for (Trip trip : trips.values()) {
      ends.add(trip.exit().at());
    }
    return ends;
  }

  private Color holder(String zone, Scene scene) {
    List<RobotId> robots = scene.robots();
    for (int i = 0; i < robots.size(); i++) {
      if (zones.held(robots.get(i)).contains(zone)) {
        Color colour = Painter.colour(i);
        return new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), HELD_ALPHA);
      }
    }
    return FREE;
  }

  private static void paintZone(Graphics2D floor, String name, Rectangle area, Color colour) {
    Rectangle2D square =
        new Rectangle2D.Double(
            area.xMinMm(),
            area.yMinMm(),
            area.xMaxMm() - area.xMinMm(),
            area.yMaxMm() - area.yMinMm());
    floor.setColor(colour);
    floor.fill(square);
    floor.setColor(BORDER);
    floor.setStroke(new BasicStroke(5));
    floor.draw(square);
    Graphics2D upright = (Graphics2D) floor.create();
    upright.transform(AffineTransform.getScaleInstance(1, -1));
    upright.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 90));
    upright.drawString(name, (int) area.xMinMm() + 18, (int) -area.yMaxMm() + 92);
    upright.dispose();
  }

  private void paintRoute(Graphics2D floor, RobotId robot, Scene scene, Color colour) {
    Trip trip = trips.get(robot);
    if (trip == null || trip.stations().isEmpty()) {
      return;
    }
    Point start = scene.trail(robot).get(0);
    Path2D path = new Path2D.Double();
    path.moveTo(start.xMm(), start.yMm());
    for (ItemPosition station : trip.stations()) {
      path.lineTo(station.at().xMm(), station.at().yMm());
    }
    path.lineTo(trip.exit().at().xMm(), trip.exit().at().yMm());
    floor.setColor(colour);
    floor.setStroke(
        new BasicStroke(18, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND, 10, DOTS, 0));
    floor.draw(path);
  }

  @Override
  public String describe(RobotId robot, Scene scene) {
    Trip trip = trips.get(robot);
    String route = trip == null ? "" : trip.label();
    String location = scene.variable(robot, IntersectionApp.SOURCE, "location");
    String held = String.join(" ", zones.held(robot));
    return route + "\n" + location + (held.isEmpty() ? "" : ", holds " + held);
  }

  @Override
  public double interest(Scene scene) {
    double interest = 0;
    for (RobotId robot : scene.robots()) {
      if (scene.pose(robot).isPresent()) {
        Point at = scene.pose(robot).get().at();
        boolean inside = false;
        for (Zone zone : Zone.values()) {
          inside |= crossing.region(zone).contains(at);
        }
        interest += inside ? 10 : 1;
      }
    }
    return interest;
  }
}
