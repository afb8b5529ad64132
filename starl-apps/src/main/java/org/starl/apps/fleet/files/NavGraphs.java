package org.starl.apps.fleet.files;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.starl.apps.fleet.logic.NavGraph;
import org.starl.apps.fleet.logic.NavGraph.Lane;
import org.starl.apps.fleet.logic.NavGraph.Vertex;
import org.starl.input.BadInput;
import org.starl.input.DocumentReader;
import org.starl.input.Node;
import org.starl.input.TextFile;
import org.starl.sim.world.GridMap;
import org.starl.sim.world.GridMaps;

/**
 * Reads navigation graphs. The file's content decides its kind: a building of Open-RMF's traffic
 * editor has {@code levels:} ({@link BuildingMap}), a map of map_server or Nav2 has {@code image:}
 * ({@link OccupancyMap}), a grid map of the path-finding benchmarks is as {@link GridMaps} has it.
 *
 * <p>A graph is the largest part in which each place can be reached from each other: a robot comes back
 * from each. It has at least two places.
 */
public final class NavGraphs {

  private static final String EXPECTED =
      "expected a building of Open-RMF (levels:), a map of map_server or Nav2 (image:) or a grid map (type octile)";

  /**
   * What is taken of a file.
   *
   * @param level of a building; empty for the first that has lanes
   * @param graph the {@code graph_idx} of the level's lanes; negative for that of
   *     most lanes
   * @param spacingMm between neighbouring places on a map, above 0
   * @param clearanceMm from a place or a lane to the nearest wall, or cell that is not free, at least 0
   */
  public record Choice(String level, int graph, double spacingMm, double clearanceMm) {

    /** First level with lanes, its largest graph; places 1 m apart, 250 mm of clearance. */
    public static final Choice DEFAULT = new Choice("", -1, 1000, 250);
  }

  private NavGraphs() {}

  /** The graph of a file by {@link Choice#DEFAULT}. */
  public static NavGraph read(Path file) {
    return read(file, Choice.DEFAULT);
  }

  /**
   * The graph of a file.
   *
   * @throws BadInput if the file, or the image that it names, cannot be read, or the choice does not fit
   *     it
   */
  public static NavGraph read(Path file, Choice choice) {
    String text = TextFile.read(file, EXPECTED);
    if (GridMaps.isMap(text)) {
      return OccupancyMap.read(file.toString(), GridMaps.parse(file.toString(), text), choice);
    }
    Node.Mapping document = DocumentReader.read(file.toString(), text, EXPECTED);
    Part whole = new Part(file.toString(), "", document);
    NavGraph graph;
    if (whole.has("levels")) {
      graph = BuildingMap.read(whole, choice);
    } else if (whole.has("image")) {
      graph = OccupancyMap.read(whole, file.resolveSibling(whole.at("image", "").text()), choice);
    } else {
      throw BadInput.at(file.toString(), 1, EXPECTED);
    }
    if (graph.vertices().size() < 2) {
      throw new BadInput(
          file + ": expected two places with lanes from each to the other, and found none");
    }
    return graph;
  }

  /** The grid map that a file has, if it is one. */
  public static Optional<GridMap> gridMap(Path file) {
    String text = TextFile.read(file, EXPECTED);
    return GridMaps.isMap(text)
        ? Optional.of(GridMaps.parse(file.toString(), text))
        : Optional.empty();
  }

  /** The graph with these places as stations, too. */
  public static NavGraph withStations(NavGraph graph, Set<Integer> places) {
    List<Vertex> vertices = new ArrayList<>(graph.vertices());
    for (int place : places) {
      Vertex v = vertices.get(place);
      if (!v.isStation()) {
        vertices.set(place, new Vertex(v.name(), v.at(), false, true, false, v.group()));
      }
    }
    return new NavGraph(vertices, graph.lanes(), graph.walls());
  }

  /**
   * The graph with the first of {@code rules} that makes two places stations; as it is if none does.
   */
  static NavGraph withStations(NavGraph graph, List<Predicate<Vertex>> rules) {
    for (Predicate<Vertex> rule : rules) {
      if (graph.vertices().stream().filter(rule).count() >= 2) {
        List<Vertex> vertices = new ArrayList<>();
        for (Vertex v : graph.vertices()) {
          vertices.add(
              new Vertex(v.name(), v.at(), v.isCharger(), rule.test(v), v.isParking(), v.group()));
        }
        return new NavGraph(vertices, graph.lanes(), graph.walls());
      }
    }
    return graph;
  }

  /** The largest part whose places are all reachable from each other; the first of equal ones. */
  static NavGraph largestPart(NavGraph graph) {
    int size = graph.vertices().size();
    List<List<Integer>> next = new ArrayList<>();
    List<List<Integer>> previous = new ArrayList<>();
    for (int v = 0; v < size; v++) {
      next.add(new ArrayList<>());
      previous.add(new ArrayList<>());
    }
    for (Lane lane : graph.lanes()) {
      next.get(lane.from()).add(lane.to());
      previous.get(lane.to()).add(lane.from());
    }
    BitSet all = new BitSet();
    all.set(0, size);
    BitSet seen = new BitSet();
    BitSet largest = new BitSet();
    for (int v = 0; v < size; v = seen.nextClearBit(v)) {
      BitSet part = reached(next, v, all);
      part.and(reached(previous, v, all));
      seen.or(part);
      largest = part.cardinality() > largest.cardinality() ? part : largest;
    }
    return part(graph, largest);
  }

  /** The places that can be reached from {@code start} over places of {@code among}. */
  static BitSet reached(List<List<Integer>> next, int start, BitSet among) {
    BitSet reached = new BitSet();
    List<Integer> open = new ArrayList<>(List.of(start));
    reached.set(start);
    while (!open.isEmpty()) {
      for (int v : next.get(open.removeLast())) {
        if (among.get(v) && !reached.get(v)) {
          reached.set(v);
          open.add(v);
        }
      }
    }
    return reached;
  }

  private static NavGraph part(NavGraph graph, BitSet kept) {
    int[] number = new int[graph.vertices().size()];
    List<Vertex> vertices = new ArrayList<>();
    for (int v = kept.nextSetBit(0); v >= 0; v = kept.nextSetBit(v + 1)) {
      number[v] = vertices.size();
      vertices.add(graph.vertices().get(v));
    }
    List<Lane> lanes = new ArrayList<>();
    for (Lane lane : graph.lanes()) {
      if (kept.get(lane.from()) && kept.get(lane.to())) {
        lanes.add(new Lane(number[lane.from()], number[lane.to()], lane.group()));
      }
    }
    return new NavGraph(vertices, lanes, graph.walls());
  }
}
