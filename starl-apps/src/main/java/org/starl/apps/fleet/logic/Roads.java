// Longer than 500 lines because sections and ways follow from one graph: its halves of lanes, its
// private vertices and its trees are tables that both use.
package org.starl.apps.fleet.logic;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.starl.apps.fleet.logic.NavGraph.Lane;
import org.starl.apps.fleet.logic.NavGraph.Vertex;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;
import org.starl.primitives.membership.Sections;

/**
 * The sections of a navigation graph, for the mutex on sequences, and the shortest ways. Immutable.
 *
 * <p>Robots drive along lanes only. The <em>star</em> of a vertex is the vertex and the half of each of
 * its lanes that is next to it; so all lanes lie in stars. A robot holds each section to whose star its
 * middle is nearer than a <em>gap</em>: two radii and what positions and lanes are missed by. The middle of
 * each robot is in a star that it holds, so two robots that touch would both hold one section. Therefore
 * no robots touch, however near vertices are and wherever lanes cross; robots in opposite directions of
 * a lane need both of its vertices. A group of lanes is a section of its own.
 *
 * <p>Some vertices are <em>private</em>: each robot's home, a parking place, and chargers and stations that
 * lie beside the ways. No way leads through one, and none comes nearer to it than a gap. A robot that stands
 * there holds no section, so it blocks no other robot, however long it stands. A home is for one robot; of
 * the other private vertices, robots hold the one that they use, as sections of a second mutex.
 */
public final class Roads {

  /** For two robots: position errors and deviations from the lane, 50 mm each. */
  private static final double SLACK_MM = 100;

  private static final double SPARE_MM = SLACK_MM / 2;

  // A robot stops so near to a vertex. It may choose among lanes that are as near; a body drives
  // beside none by more than SPARE_MM.
  private static final double AT_VERTEX_MM = 20;

  // A robot that waits before a lane stops so near to the lane's end, and knows its position so
  // well.
  private static final double AT_END_MM = 60;

  private static final int MOST_MERGED = 8;
  private static final int MOST_REFUGES = 8;
  private static final int NONE = -1;

  private final NavGraph graph;
  private final double gapMm;
  private final double squareMm; // a lane is in few squares, however long and narrow
  private final List<Integer> homes = new ArrayList<>();
  private final List<Integer> chargers = new ArrayList<>();
  private final List<Integer> stations;
  private final Map<Integer, int[]> trees = new TreeMap<>(); // by home, charger and station
  private final Set<Integer> closed = new TreeSet<>(); // private
  private final List<List<Integer>> lanesFrom = new ArrayList<>();
  private final SortedMap<String, List<Half>> stars = new TreeMap<>();
  private final Map<Long, Set<String>> near = new TreeMap<>(); // stars, by squares of the floor
  private final SortedMap<String, String> groups = new TreeMap<>();
  private final List<List<String>> needs = new ArrayList<>(); // of each lane
  private final List<Integer> shared = new ArrayList<>();
  private final double longestMm;

  /** A part of a star; {@code owner} is the private vertex of its lane, or {@link #NONE}. */
  private record Half(Segment segment, int owner) {}

  private record Reached(double mm, int vertex) {}

  /**
   * @param bodyMm radius of the robots
   * @param robots their number
   * @throws IllegalArgumentException if the graph has not as many parking places apart from its ways, if
   *     a robot cannot reach a station and come back, or would need too many sections for that
   */
  public Roads(NavGraph graph, double bodyMm, int robots) {
    this.graph = graph;
    gapMm = 2 * bodyMm + SLACK_MM;
    squareMm =
        graph.lanes().stream()
            .mapToDouble(graph::lengthMm)
            .reduce(Math.max(gapMm, SLACK_MM), Math::max);
    stations = graph.stations();
    for (int v = 0; v < graph.vertices().size(); v++) {
      lanesFrom.add(new ArrayList<>());
    }
    for (int i = 0; i < graph.lanes().size(); i++) {
      Lane lane = graph.lanes().get(i);
      lanesFrom.get(lane.from()).add(i);
      graph.groups(lane).forEach(group -> groups.putIfAbsent(group, "g" + groups.size()));
    }
    chooseHomes(robots);
    for (int v = 0; v < graph.vertices().size(); v++) {
      if (vertex(v).isCharger() && isApart(v) && neighbours(v) == 1 && !homes.contains(v)) {
        chargers.add(v);
      }
    }
    closed.addAll(homes);
    closed.addAll(chargers);
    stations.stream().filter(v -> isApart(v) && !isInGroup(v)).forEach(closed::add);
    growTrees();
    if (!isConnected()) {
      closed.removeAll(stations);
      growTrees();
    }
    shared.addAll(chargers);
    stations.stream().filter(closed::contains).forEach(shared::add);
    List<List<Integer>> trips = trips();
    longestMm = 3 * trips.stream().mapToDouble(this::lengthMm).max().orElse(0);
    int merged = 1;
    while (!divide(merged, trips)) {
      merged++;
      if (merged > MOST_MERGED) {
        throw new IllegalArgumentException(
            "a way between parking places and stations has too many vertices: expected at most "
                + Sections.MAX_COUNT * MOST_MERGED
                + "; on a map of cells, a larger spacing makes fewer");
      }
    }
  }

  /** Places at the end of a lane; first those where no other robot wants to charge. */
  private void chooseHomes(int robots) {
    for (boolean isCharger : new boolean[] {false, true}) {
      for (int v = 0; v < graph.vertices().size(); v++) {
        boolean isHome = vertex(v).isParking() && !vertex(v).isStation() && neighbours(v) == 1;
        if (isHome && vertex(v).isCharger() == isCharger && isApart(v)) {
          homes.add(v);
        }
      }
    }
    if (homes.size() < robots) {
      throw new IllegalArgumentException(
          homes.size()
              + " parking places at the end of a lane, "
              + Math.round(gapMm)
              + " mm from all others: expected one for each of "
              + robots
              + " robots, or fewer robots");
    }
    homes.subList(robots, homes.size()).clear();
  }

  private int neighbours(int vertex) {
    Set<Integer> neighbours = new TreeSet<>();
    for (Lane lane : graph.lanes()) {
      if (lane.from() == vertex || lane.to() == vertex) {
        neighbours.add(lane.from() == vertex ? lane.to() : lane.from());
      }
    }
    return neighbours.size();
  }

  /** Whether a body here keeps the gap to all lanes but its own, and to the other ends of these. */
  private boolean isApart(int vertex) {
    return graph.lanes().stream()
        .allMatch(lane -> {
          boolean isOwn = lane.from() == vertex || lane.to() == vertex;
          return (isOwn ? graph.lengthMm(lane) : segment(lane).distanceMm(at(vertex))) >= gapMm;
        });
  }

  /** Whether other vertices or lanes have the group here: a robot that stands here keeps these closed. */
  private boolean isInGroup(int vertex) {
    String group = vertex(vertex).group();
    return !group.isEmpty()
        && graph.lanes().stream()
            .anyMatch(lane ->
                lane.from() != vertex && lane.to() != vertex && graph.groups(lane).contains(group));
  }

  private void growTrees() {
    trees.clear();
    for (List<Integer> ends : List.of(homes, chargers, stations)) {
      ends.forEach(end -> trees.put(end, tree(end, Set.of())));
    }
  }

  /** Whether each home, charger and station can be reached from each other one. */
  private boolean isConnected() {
    return trees.entrySet().stream()
        .allMatch(tree ->
            trees.keySet().stream()
                .allMatch(to -> to.equals(tree.getKey()) || tree.getValue()[to] != NONE));
  }

  private Vertex vertex(int number) {
    return graph.vertices().get(number);
  }

  /** The ways between private vertices that robots drive. */
  private List<List<Integer>> trips() {
    List<Integer> stops = new ArrayList<>(stations);
    stops.addAll(chargers);
    List<List<Integer>> trips = new ArrayList<>();
    for (int home : homes) {
      for (int stop : stops) {
        if (isPrivate(stop)) {
          trips.add(way(home, stop));
          trips.add(way(stop, home));
        } else {
          trips.add(way(home, List.of(stop, home)));
        }
      }
    }
    for (int from : stations) {
      for (int to : stations) {
        if (from != to && isPrivate(from) && isPrivate(to)) {
          trips.add(way(from, to));
        }
      }
    }
    return trips;
  }

  /** Divides the floor into sections of this many neighbours; false if a trip has too many sections. */
  private boolean divide(int merged, List<List<Integer>> trips) {
    stars.clear();
    needs.clear();
    String[] sections = new String[graph.vertices().size()];
    for (int v = 0; v < sections.length; v++) {
      if (sections[v] == null && !closed.contains(v)) {
        name(v, "v" + v, merged, sections);
      }
    }
    for (int v = 0; v < sections.length; v++) {
      if (sections[v] != null) {
        star(sections[v]).add(new Half(new Segment(at(v), at(v)), NONE));
      }
    }
    for (Lane lane : graph.lanes()) {
      addHalf(lane.from(), lane.to(), sections);
      addHalf(lane.to(), lane.from(), sections);
    }
    near.clear();
    stars.forEach((section, halves) ->
        halves.forEach(half ->
            squares(half.segment(), gapMm)
                .forEach(at -> near.computeIfAbsent(at, any -> new TreeSet<>()).add(section))));
    for (Lane lane : graph.lanes()) {
      needs.add(needs(at(lane.from()), lane));
    }
    return trips.stream().allMatch(this::fits);
  }

  private List<Half> star(String section) {
    return stars.computeIfAbsent(section, name -> new ArrayList<>());
  }

  /** Gives a section to a vertex and to so many neighbours in all. A station is alone. */
  private void name(int vertex, String section, int merged, String[] sections) {
    List<Integer> members = new ArrayList<>(List.of(vertex));
    sections[vertex] = section;
    for (int i = 0; i < members.size(); i++) {
      for (int lane : lanesFrom.get(members.get(i))) {
        int next = graph.lanes().get(lane).to();
        boolean isAlone = vertex(vertex).isStation() || vertex(next).isStation();
        if (members.size() < merged
            && sections[next] == null
            && !closed.contains(next)
            && !isAlone) {
          sections[next] = section;
          members.add(next);
        }
      }
    }
  }

  private void addHalf(int from, int to, String[] sections) {
    if (sections[from] != null) {
      Point end = closed.contains(to) ? at(to) : at(from).plus(at(to).minus(at(from)).times(0.5));
      star(sections[from])
          .add(new Half(new Segment(at(from), end), closed.contains(to) ? to : NONE));
    }
  }

  /** The squares, each as large as the longest lane, around a line and a margin of it. */
  private List<Long> squares(Segment line, double marginMm) {
    Point a = line.from();
    Point b = line.to();
    List<Long> squares = new ArrayList<>();
    long top = square(Math.max(a.yMm(), b.yMm()) + marginMm);
    long right = square(Math.max(a.xMm(), b.xMm()) + marginMm);
    for (long y = square(Math.min(a.yMm(), b.yMm()) - marginMm); y <= top; y++) {
      for (long x = square(Math.min(a.xMm(), b.xMm()) - marginMm); x <= right; x++) {
        squares.add((y << Integer.SIZE) + x);
      }
    }
    return squares;
  }

  private long square(double mm) {
    return (long) Math.floor(mm / squareMm);
  }

  /** The sections that a robot needs on a line, those at its beginning first. */
  private List<String> needs(Segment line, Collection<Integer> own) {
    List<String> its = new ArrayList<>(near(line));
    its.removeIf(section -> distanceMm(section, line, own) >= gapMm);
    Segment start = new Segment(line.from(), line.from());
    its.sort(Comparator.comparingDouble(section -> distanceMm(section, start, own)));
    return its;
  }

  /** All sections whose star may be within a gap of this line. */
  private Set<String> near(Segment line) {
    Set<String> its = new TreeSet<>();
    squares(line, 0).forEach(at -> its.addAll(near.getOrDefault(at, Set.of())));
    return its;
  }

  /** The distance from a section's star, but for lanes to own private vertices. */
  private double distanceMm(String section, Segment line, Collection<Integer> own) {
    double mm = Double.POSITIVE_INFINITY;
    for (Half half : stars.getOrDefault(section, List.of())) {
      if (half.owner() == NONE || !own.contains(half.owner())) {
        mm = Math.min(mm, half.segment().distanceMm(line));
      }
    }
    return mm;
  }

  /**
   * Whether a robot has left a section.
   *
   * @param at its middle
   * @param errorMm bound of the error of that
   * @param own private vertices that it uses
   */
  boolean isClear(String section, Point at, double errorMm, Collection<Integer> own) {
    return groups.containsValue(section)
        || distanceMm(section, new Segment(at, at), own) - errorMm >= gapMm - SPARE_MM;
  }

  /** The sections in which a robot may be that stands here. */
  List<String> occupied(Point at, double errorMm, Collection<Integer> own) {
    List<String> occupied = new ArrayList<>(stars.keySet());
    occupied.removeIf(section -> isClear(section, at, errorMm, own));
    return occupied;
  }

  /** The sections that every robot holds whose middle is here, whatever private vertices it uses. */
  public Set<String> around(Point at) {
    Set<String> its = near(new Segment(at, at));
    its.removeIf(section -> isClear(section, at, 0, closed));
    shared.stream()
        .filter(vertex -> at(vertex).distanceMm(at) < AT_END_MM)
        .forEach(vertex -> its.add(Places.section(vertex)));
    return its;
  }

  /** The sections for the drive along a way, vertex by vertex. */
  List<List<String>> needs(List<Integer> way) {
    List<List<String>> all = new ArrayList<>();
    for (int i = 0; i + 1 < way.size(); i++) {
      all.add(needs(way.get(i), way.get(i + 1)));
    }
    return all;
  }

  /** The sections to a vertex from a point on a lane; also those of the lane's groups. */
  List<String> needs(Point from, Lane lane) {
    List<String> its = needs(new Segment(from, at(lane.to())), List.of(lane.from(), lane.to()));
    its.addAll(sections(graph.groups(lane)));
    return its;
  }

  /**
   * The groups, as sections, that a robot has which stands here on a lane after a restart. At an end of the
   * lane it may wait for the lane's groups, and has that of the vertex; at a private end, none.
   */
  List<String> groups(Point at, Lane lane) {
    Set<String> its = new TreeSet<>(graph.groups(lane));
    for (int end : List.of(lane.from(), lane.to())) {
      if (at.distanceMm(at(end)) < AT_END_MM) {
        its.retainAll(isPrivate(end) ? Set.of() : Set.of(vertex(end).group()));
      }
    }
    return sections(its);
  }

  private List<String> sections(Collection<String> itsGroups) {
    return itsGroups.stream().map(this::section).collect(Collectors.toList());
  }

  /** The section of a group. */
  public String section(String group) {
    return groups.getOrDefault(group, "");
  }

  /** Whether a sequence of the mutex has room for all sections of this way. */
  boolean fits(List<Integer> way) {
    Set<String> all = new TreeSet<>();
    needs(way).forEach(all::addAll);
    return all.size() <= Sections.MAX_COUNT;
  }

  /**
   * The lane on which a robot is that stands here; of several, that of the shortest way to this end. A robot
   * may turn back on a lane to another private vertex, also against its direction: that vertex may be taken.
   */
  Lane laneAt(Point at, int end) {
    double nearestMm =
        graph.lanes().stream().mapToDouble(lane -> segment(lane).distanceMm(at)).min().orElse(0);
    return graph.lanes().stream()
        .filter(lane -> segment(lane).distanceMm(at) <= nearestMm + AT_VERTEX_MM)
        .map(lane -> lane.to() == end || !isPrivate(lane.to()) ? lane : lane.reversed())
        .min(Comparator.comparingDouble(lane -> awayMm(at, lane, end)))
        .orElseThrow();
  }

  private double awayMm(Point at, Lane lane, int end) {
    return at.distanceMm(at(lane.to())) + lengthMm(way(lane.to(), end));
  }

  /**
   * Private vertices for a robot that stands here on a lane, the nearest first: some near ones, up to its
   * home.
   */
  List<Integer> refuges(Point at, int home) {
    List<Integer> ends = new ArrayList<>(shared);
    ends.sort(Comparator.comparingDouble(end -> at.distanceMm(at(end))));
    ends.subList(Math.min(MOST_REFUGES, ends.size()), ends.size()).clear();
    ends.add(home);
    ends.sort(Comparator.comparingDouble(end -> awayMm(at, laneAt(at, end), end)));
    return ends.subList(0, ends.indexOf(home) + 1);
  }

  /** The shortest way over all stops, of which the last one is the end. */
  List<Integer> way(int from, List<Integer> stops) {
    List<Integer> way = new ArrayList<>(List.of(from));
    int last = from;
    for (int stop : stops) {
      List<Integer> part = way(last, stop);
      way.addAll(part.subList(1, part.size()));
      last = stop;
    }
    return way;
  }

  /**
   * The shortest way through none of these sections, which a dead robot may be in; none if there is no such
   * way, or it needs too many sections.
   */
  Optional<List<Integer>> wayAround(int from, List<Integer> stops, Set<String> shut) {
    if (shut.isEmpty()) {
      return Optional.of(way(from, stops));
    }
    List<Integer> way = new ArrayList<>(List.of(from));
    int last = from;
    for (int stop : stops) {
      List<Integer> part = way(last, stop, tree(last, shut));
      if (part.isEmpty()) {
        return Optional.empty();
      }
      way.addAll(part.subList(1, part.size()));
      last = stop;
    }
    return fits(way) ? Optional.of(way) : Optional.empty();
  }

  /**
   * The part of a drive over stops that ends at a private vertex: the first private stop, or the home after
   * all stops, or after the first one if there are too many sections on the way.
   */
  List<Integer> leg(int from, List<Integer> stops, int home) {
    List<Integer> leg = new ArrayList<>();
    for (int stop : stops) {
      leg.add(stop);
      if (isPrivate(stop)) {
        return leg;
      }
    }
    leg.add(home);
    return fits(way(from, leg)) ? leg : List.of(leg.get(0), home);
  }

  /** The shortest way; of equal ones always the same. */
  private List<Integer> way(int from, int to) {
    int[] known = trees.get(from);
    List<Integer> way = way(from, to, known == null ? tree(from, Set.of()) : known);
    if (way.isEmpty()) {
      throw new IllegalArgumentException(
          "no way from " + name(from) + " to " + name(to) + ": expected lanes between them");
    }
    return way;
  }

  /** Empty if there is none. */
  private static List<Integer> way(int from, int to, int[] before) {
    List<Integer> way = new ArrayList<>(List.of(to));
    for (int last = to; last != from; ) {
      last = before[last];
      if (last == NONE) {
        return List.of();
      }
      way.add(last);
    }
    Collections.reverse(way);
    return way;
  }

  /** For each vertex the one before it on the way from {@code from}; {@link #NONE} if there is no way. */
  private int[] tree(int from, Set<String> shut) {
    double[] mm = new double[graph.vertices().size()];
    int[] before = new int[mm.length];
    Arrays.fill(mm, Double.POSITIVE_INFINITY);
    Arrays.fill(before, NONE);
    mm[from] = 0;
    PriorityQueue<Reached> queue =
        new PriorityQueue<>(
            Comparator.comparingDouble(Reached::mm).thenComparingInt(Reached::vertex));
    queue.add(new Reached(0, from));
    while (!queue.isEmpty()) {
      Reached next = queue.remove();
      boolean isOpen = next.vertex() == from || !closed.contains(next.vertex());
      if (next.mm() > mm[next.vertex()] || !isOpen) {
        continue;
      }
      for (int number : lanesFrom.get(next.vertex())) {
        Lane lane = graph.lanes().get(number);
        double itsMm = next.mm() + graph.lengthMm(lane);
        boolean isShut = !shut.isEmpty() && !Collections.disjoint(needs.get(number), shut);
        if (itsMm < mm[lane.to()] && !isShut) {
          mm[lane.to()] = itsMm;
          before[lane.to()] = next.vertex();
          queue.add(new Reached(itsMm, lane.to()));
        }
      }
    }
    return before;
  }

  /** Those of the shortest lane; of a lane that is driven back, those under it. */
  private List<String> needs(int from, int to) {
    return lanesFrom.get(from).stream()
        .filter(lane -> graph.lanes().get(lane).to() == to)
        .min(Comparator.comparingDouble(lane -> graph.lengthMm(graph.lanes().get(lane))))
        .map(needs::get)
        .orElseGet(() -> needs(at(from), new Lane(from, to, "")));
  }

  private double lengthMm(List<Integer> way) {
    double mm = 0;
    for (int i = 0; i + 1 < way.size(); i++) {
      mm += at(way.get(i)).distanceMm(at(way.get(i + 1)));
    }
    return mm;
  }

  private Segment segment(Lane lane) {
    return new Segment(at(lane.from()), at(lane.to()));
  }

  private String name(int vertex) {
    return vertex(vertex).name();
  }

  /** The graph. */
  public NavGraph graph() {
    return graph;
  }

  /** Where a vertex is. */
  public Point at(int vertex) {
    return vertex(vertex).at();
  }

  /** The vertex where a robot stands at the start and between its deliveries. */
  public int home(int robot) {
    return homes.get(robot);
  }

  /** The vertices where robots charge. */
  public List<Integer> chargers() {
    return List.copyOf(chargers);
  }

  /** The chargers and the private stations, which one robot uses after another. */
  List<Integer> shared() {
    return List.copyOf(shared);
  }

  /** Whether robots stand at this vertex without a section. */
  boolean isPrivate(int vertex) {
    return closed.contains(vertex);
  }

  /** Whether robots can charge anywhere. */
  public boolean hasChargers() {
    return !chargers.isEmpty() || homes.stream().allMatch(home -> vertex(home).isCharger());
  }

  /** At most this far a robot drives for one delivery, in mm. */
  public double longestMm() {
    return longestMm;
  }
}
