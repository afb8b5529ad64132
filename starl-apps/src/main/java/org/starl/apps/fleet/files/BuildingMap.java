package org.starl.apps.fleet.files;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.starl.apps.fleet.logic.NavGraph;
import org.starl.apps.fleet.logic.NavGraph.Lane;
import org.starl.apps.fleet.logic.NavGraph.Vertex;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;
import org.starl.input.BadInput;
import org.starl.input.Field;

/**
 * One level of a {@code building.yaml} of Open-RMF's traffic editor, as its nav graphs are made: the
 * vertices are those of the lanes of one {@code graph_idx}, and a bidirectional lane is two.
 *
 * <ul>
 *   <li>Coordinates: {@code reference_image} (the default: pixels, y down) with the scale of the
 *       level's measurements, the mean of distance by length; {@code cartesian_meters}, less {@code
 *       offset_x} and {@code offset_y}; {@code wgs84} (longitude, latitude), metres in the plane that touches the ellipsoid in
 *       the middle of the graph.
 *   <li>Chargers are {@code is_charger}. Robots may park on {@code is_parking_spot}, {@code
 *       is_holding_point} and chargers. Stations have a {@code pickup_dispenser} or a {@code
 *       dropoff_ingestor}; if fewer than two have: the named places but chargers; else all but chargers; else all.
 *   <li>The group of a lane or a vertex is its {@code mutex}.
 *   <li>A place without a name is called v and its number in the level's list.
 * </ul>
 *
 * <p>Walls are in the world and in pictures; a wall ends where a door is. Not used: doors, lifts, speed limits and {@code orientation} (robots of StarL turn in
 * place).
 */
final class BuildingMap {

  private static final double MM_PER_M = 1000;
  private static final double MOST_MM = 1e9;

  /** Of WGS 84, in m, and the square of its eccentricity. */
  private static final double EQUATOR_M = 6_378_137;

  private static final double ECCENTRICITY_2 = 6.694_379_990_14e-3;

  private static final Field<Double> NUMBER = Field.decimal("", -1e9, 1e9, "");
  private static final Field<Double> LENGTH = Field.decimal("", 1e-6, 1e9, "");
  private static final Field<Integer> GRAPH = Field.whole("", 0, 1000, "");
  private static final Field<Boolean> YES_NO = Field.yesNo("", "");
  private static final Field<String> SYSTEM =
      Field.choice("", "", "reference_image", "cartesian_meters", "wgs84");

  private static final String EDGE = "[FROM, TO, {...}], two numbers of vertices";
  private static final String PLACE = "[X, Y, Z, NAME, {...}]";
  private static final String PARAMETER = "[TYPE, VALUE]";

  private record Ends(int from, int to) {}

  private final Part building;
  private final Part level;
  private final String system;

  /** Every vertex of the level, in its list. */
  private final List<Part> vertices;

  private BuildingMap(Part building, Part level) {
    this.building = building;
    this.level = level;
    system =
        building.has("coordinate_system")
            ? building.at("coordinate_system", "").as(SYSTEM)
            : "reference_image";
    vertices = level.list("vertices");
  }

  /** The largest part of the chosen level and graph. */
  static NavGraph read(Part building, NavGraphs.Choice choice) {
    return new BuildingMap(building, level(building, choice.level())).graph(choice);
  }

  private static Part level(Part building, String name) {
    Part levels = building.at("levels", "");
    Set<String> withLanes = new LinkedHashSet<>();
    for (String key : levels.keys()) {
      if (!levels.at(key, "").list("lanes").isEmpty()) {
        withLanes.add(key);
      }
    }
    if (withLanes.isEmpty()) {
      throw levels.wrong("a level with lanes");
    }
    if (!name.isEmpty() && !withLanes.contains(name)) {
      throw new BadInput(
          String.format(
              "%s: level %s: expected one of %s",
              building.file(), BadInput.quote(name), String.join(", ", withLanes)));
    }
    return levels.at(name.isEmpty() ? withLanes.iterator().next() : name, "");
  }

  private NavGraph graph(NavGraphs.Choice choice) {
    List<Part> lanes = lanes(choice.graph());
    // As in nav graphs, only vertices with lanes, in the order of the lanes.
    Set<Integer> ordered = new LinkedHashSet<>();
    for (Part lane : lanes) {
      Ends ends = ends(lane);
      ordered.add(ends.from());
      ordered.add(ends.to());
    }
    if (ordered.size() > OccupancyMap.MOST_PLACES) {
      throw level.wrong("at most " + OccupancyMap.MOST_PLACES + " places with lanes of one graph");
    }
    List<Integer> used = List.copyOf(ordered);
    List<Integer> all = new ArrayList<>(used);
    for (Part wall : level.list("walls")) {
      Ends ends = ends(wall);
      all.addAll(List.of(ends.from(), ends.to()));
    }
    List<Point> points = points(all, used.size());
    Obstacles walls = walls(points.subList(used.size(), points.size()));
    Set<String> given = given(used);
    List<Vertex> places = new ArrayList<>();
    for (int i = 0; i < used.size(); i++) {
      places.add(vertex(used.get(i), points.get(i), given));
    }
    Map<Ends, Lane> directed = new LinkedHashMap<>();
    for (Part lane : lanes) {
      Ends ends = ends(lane);
      int from = used.indexOf(ends.from());
      int to = used.indexOf(ends.to());
      if (points.get(from).distanceMm(points.get(to)) < 1) {
        throw lane.wrong("a lane between two places that are at least 1 mm apart");
      }
      Segment line = new Segment(points.get(from), points.get(to));
      if (walls.isWithin(line, choice.clearanceMm())) {
        throw lane.wrong("a lane with a clearance of " + choice.clearanceMm() + " mm to all walls");
      }
      add(directed, new Lane(from, to, word(lane, 2, "mutex")));
      if (flag(lane, 2, "bidirectional")) {
        add(directed, new Lane(to, from, word(lane, 2, "mutex")));
      }
    }
    return NavGraphs.withStations(
        NavGraphs.largestPart(new NavGraph(places, List.copyOf(directed.values()), walls)),
        List.of(
            Vertex::isStation,
            v -> !v.isCharger() && given.contains(v.name()),
            v -> !v.isCharger(),
            v -> true));
  }

  /** From each second point to the next one. */
  private static Obstacles walls(List<Point> ends) {
    List<Obstacle> walls = new ArrayList<>();
    for (int i = 0; i < ends.size(); i += 2) {
      walls.add(Obstacle.wall(ends.get(i), ends.get(i + 1)));
    }
    return new Obstacles(walls);
  }

  /** A lane may be drawn twice. */
  private static void add(Map<Ends, Lane> lanes, Lane lane) {
    lanes.merge(new Ends(lane.from(), lane.to()), lane, (a, b) -> a.group().isEmpty() ? b : a);
  }

  private List<Part> lanes(int chosen) {
    List<Part> all = level.list("lanes");
    SortedMap<Integer, Integer> graphs = new TreeMap<>();
    all.forEach(lane -> graphs.merge(graphOf(lane), 1, Integer::sum));
    if (chosen >= 0 && !graphs.containsKey(chosen)) {
      throw new BadInput(
          String.format(
              "%s: graph '%s': expected one of %s, the graph_idx of %s",
              level.file(),
              chosen,
              graphs.keySet().stream().map(String::valueOf).collect(Collectors.joining(", ")),
              level.path()));
    }
    // Of equal ones the first, which has the lowest number.
    int most = Collections.max(graphs.entrySet(), Map.Entry.comparingByValue()).getKey();
    int graph = chosen >= 0 ? chosen : most;
    return all.stream().filter(lane -> graphOf(lane) == graph).toList();
  }

  private static int graphOf(Part lane) {
    return hasParameter(lane, 2, "graph_idx") ? parameter(lane, 2, "graph_idx").as(GRAPH) : 0;
  }

  private Ends ends(Part edge) {
    List<Part> items = edge.items(2, EDGE);
    return new Ends(end(items.get(0)), end(items.get(1)));
  }

  private int end(Part number) {
    if (vertices.isEmpty()) {
      throw number.wrong("a vertex, and the level has none");
    }
    return number.as(Field.whole("", 0, vertices.size() - 1, ""));
  }

  private Vertex vertex(int index, Point at, Set<String> given) {
    Part vertex = vertices.get(index);
    String name = name(vertex).isEmpty() ? "v" + index : name(vertex);
    while (name(vertex).isEmpty() && given.contains(name)) {
      name += "_";
    }
    boolean isCharger = flag(vertex, 4, "is_charger");
    boolean isStation = hasWord(vertex, "pickup_dispenser") || hasWord(vertex, "dropoff_ingestor");
    boolean isParking =
        isCharger || flag(vertex, 4, "is_parking_spot") || flag(vertex, 4, "is_holding_point");
    return new Vertex(name, at, isCharger, isStation, isParking, word(vertex, 4, "mutex"));
  }

  private static boolean hasWord(Part vertex, String key) {
    return !word(vertex, 4, key).isEmpty();
  }

  /** The names of vertices that have one. */
  private Set<String> given(List<Integer> indexes) {
    Set<String> names = new TreeSet<>();
    for (int index : indexes) {
      String name = name(vertices.get(index));
      if (!name.isEmpty() && !names.add(name)) {
        Part again = vertices.get(index).items(4, PLACE).get(3);
        throw again.wrong("a name that no other place of the graph has");
      }
    }
    return names;
  }

  /** Empty if it has none. */
  private static String name(Part vertex) {
    List<Part> items = vertex.items(2, PLACE);
    return items.size() > 3 ? items.get(3).text() : "";
  }

  private static boolean flag(Part item, int index, String key) {
    return hasParameter(item, index, key) && parameter(item, index, key).as(YES_NO);
  }

  private static String word(Part item, int index, String key) {
    return hasParameter(item, index, key) ? parameter(item, index, key).text() : "";
  }

  private static boolean hasParameter(Part item, int index, String key) {
    List<Part> items = item.items(2, index == 2 ? EDGE : PLACE);
    return items.size() > index && items.get(index).has(key);
  }

  private static Part parameter(Part item, int index, String key) {
    Part parameter = item.items(index + 1, EDGE).get(index).at(key, PARAMETER);
    return parameter.items(2, PARAMETER).get(1);
  }

  /** The places of some vertices, in mm, y up; the first {@code count} are those of the graph. */
  private List<Point> points(List<Integer> indexes, int count) {
    List<Point> raw = indexes.stream().map(index -> raw(vertices.get(index))).toList();
    List<Point> points =
        switch (system) {
          case "cartesian_meters" -> {
            Point offset = new Point(offset("offset_x"), offset("offset_y"));
            yield raw.stream().map(point -> point.minus(offset).times(MM_PER_M)).toList();
          }
          case "wgs84" -> plane(raw, count);
          default -> {
            double scale = metresPerPixel() * MM_PER_M;
            yield raw.stream()
                .map(point -> new Point(point.xMm() * scale, 0 - point.yMm() * scale))
                .toList();
          }
        };
    for (int i = 0; i < points.size(); i++) {
      Point point = points.get(i);
      if (Math.max(Math.abs(point.xMm()), Math.abs(point.yMm())) > MOST_MM) {
        throw vertices.get(indexes.get(i)).wrong("a place within 1000 km of the origin");
      }
    }
    return points;
  }

  private Point raw(Part vertex) {
    List<Part> items = vertex.items(2, PLACE);
    double x = items.get(0).as(NUMBER);
    double y = items.get(1).as(NUMBER);
    if (system.equals("wgs84") && (Math.abs(x) > 180 || Math.abs(y) > 89)) {
      throw vertex.wrong("a longitude from -180 to 180 and a latitude from -89 to 89");
    }
    return new Point(x, y);
  }

  private double offset(String key) {
    boolean isGiven = building.has("parameters") && building.at("parameters", "").has(key);
    return isGiven
        ? building.at("parameters", "").at(key, "").items(2, PARAMETER).get(1).as(NUMBER)
        : 0;
  }

  /** Of longitudes and latitudes in degrees; the first {@code count} decide the middle. */
  private static List<Point> plane(List<Point> degrees, int count) {
    Point middle = new Point(0, 0);
    for (Point point : degrees.subList(0, count)) {
      middle = middle.plus(point.times(1.0 / count));
    }
    double latitude = StrictMath.toRadians(middle.yMm());
    double sine = StrictMath.sin(latitude);
    double w = 1 - ECCENTRICITY_2 * sine * sine;
    double eastM = EQUATOR_M / StrictMath.sqrt(w) * StrictMath.cos(latitude);
    double northM = EQUATOR_M * (1 - ECCENTRICITY_2) / StrictMath.pow(w, 1.5);
    double mmPerDegree = StrictMath.PI / 180 * MM_PER_M;
    List<Point> points = new ArrayList<>();
    for (Point point : degrees) {
      Point from = point.minus(middle).times(mmPerDegree);
      points.add(new Point(from.xMm() * eastM, from.yMm() * northM));
    }
    return points;
  }

  /** The mean of the level's measurements, as the traffic editor has it. */
  private double metresPerPixel() {
    List<Double> scales = new ArrayList<>();
    for (Part measurement : level.list("measurements")) {
      Ends ends = ends(measurement);
      double pixels = raw(vertices.get(ends.from())).distanceMm(raw(vertices.get(ends.to())));
      if (pixels == 0 || !hasParameter(measurement, 2, "distance")) {
        throw measurement.wrong("[FROM, TO, {distance: [3, METRES]}] between two places");
      }
      scales.add(parameter(measurement, 2, "distance").as(LENGTH) / pixels);
    }
    if (scales.isEmpty()) {
      throw level.wrong(
          "measurements: [FROM, TO, {distance: [3, METRES]}], the scale of the drawing");
    }
    return scales.stream().mapToDouble(scale -> scale).sum() / scales.size();
  }
}
