package org.starl.apps.fleet.files;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.LongSupplier;
import org.starl.apps.fleet.logic.Delivery;
import org.starl.apps.fleet.logic.NavGraph;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.input.TextFile;
import org.starl.sim.world.GridMap;
import org.starl.sim.world.GridTrips;
import org.starl.time.Time;

/**
 * Reads lists of deliveries, in two forms. Empty lines and the text after {@code #} are ignored.
 *
 * <ul>
 *   <li>StarL's: each line has a time with its unit and the names of two stations, as in {@code 90s pantry
 *       coe}.
 *   <li>That of Ma et al. 2017 for pickup and delivery with many agents: the first line has the number of tasks, each
 *       other line a time step and the numbers of two stations, from 0 in the graph's order; a fourth and fifth
 *       number, the time steps that a robot stays there, must be 0.
 * </ul>
 */
public final class Deliveries {

  private static final String EXPECTED = "expected a list of deliveries";
  private static final int LONGEST_STEP = 100_000_000;

  private final String file;
  private final NavGraph graph;
  private final List<Integer> stations;
  private final List<Delivery> deliveries = new ArrayList<>();

  private Deliveries(String file, NavGraph graph) {
    this.file = file;
    this.graph = graph;
    stations = graph.stations();
  }

  /**
   * The deliveries of a file, by time, and at equal times in the file's order.
   *
   * @param stepMs a time step of a file in the second form
   * @throws BadInput if the file cannot be read, has no delivery, or does not fit the graph
   */
  public static List<Delivery> read(Path file, NavGraph graph, long stepMs) {
    Deliveries reader = new Deliveries(file.toString(), graph);
    return reader.read(TextFile.read(file, EXPECTED).split("\r\n|\r|\n", -1), stepMs);
  }

  /**
   * The trips of a list of starts and goals on a grid map, all of them asked for at once.
   *
   * @param graph of the map
   * @param most so many are read
   * @throws BadInput if the file cannot be read, has no trip, or does not fit the map
   */
  public static List<Delivery> ofTrips(Path file, GridMap map, NavGraph graph, int most) {
    Map<String, Integer> places = new TreeMap<>();
    for (int v = 0; v < graph.vertices().size(); v++) {
      places.put(graph.vertices().get(v).name(), v);
    }
    Deliveries reader = new Deliveries(file.toString(), graph);
    for (GridTrips.Trip trip : GridTrips.read(file, map, most)) {
      List<Integer> ends = new ArrayList<>();
      for (int cell : List.of(trip.from(), trip.to())) {
        String name = OccupancyMap.name(cell % map.columns(), cell / map.columns());
        Integer place = places.get(name);
        if (place == null) {
          throw reader.wrong(trip.line(), name, "a cell of the largest part of the map");
        }
        ends.add(place);
      }
      reader.add(trip.line(), 0, ends.get(0), ends.get(1));
    }
    if (reader.deliveries.isEmpty()) {
      throw new BadInput(file + ": has no delivery; " + EXPECTED);
    }
    return List.copyOf(reader.deliveries);
  }

  private List<Delivery> read(String[] lines, long stepMs) {
    Map<Integer, List<String>> wordsByLine = new LinkedHashMap<>();
    for (int i = 0; i < lines.length; i++) {
      String text = lines[i].replaceFirst("#.*", "").trim();
      if (!text.isEmpty()) {
        wordsByLine.put(i + 1, List.of(text.split("\\s+")));
      }
    }
    if (wordsByLine.isEmpty()) {
      throw new BadInput(file + ": has no delivery; " + EXPECTED);
    }
    Map.Entry<Integer, List<String>> first = wordsByLine.entrySet().iterator().next();
    if (first.getValue().size() == 1) {
      wordsByLine.remove(first.getKey());
      int count = whole(first.getKey(), first.getValue().get(0), 1, 10_000_000);
      if (wordsByLine.size() != count) {
        throw wrong(first.getKey(), "" + count, "the number of tasks, " + wordsByLine.size());
      }
      wordsByLine.forEach((line, words) -> addTask(line, words, stepMs));
    } else {
      wordsByLine.forEach(this::add);
    }
    deliveries.sort((a, b) -> Long.compare(a.atMs(), b.atMs()));
    return List.copyOf(deliveries);
  }

  private void add(int line, List<String> words) {
    if (words.size() != 3) {
      throw wrong(line, String.join(" ", words), "TIME FROM TO, such as 90s pantry coe");
    }
    long ns = at(line, () -> Quantities.durationNs(words.get(0)));
    add(line, ns / Time.NS_PER_MS, named(line, words.get(1)), named(line, words.get(2)));
  }

  private int named(int line, String name) {
    for (int station : stations) {
      if (name(station).equals(name)) {
        return station;
      }
    }
    String first = stations.isEmpty() ? "" : name(stations.get(0));
    throw wrong(line, name, "the name of a station of the graph, such as " + first);
  }

  private String name(int vertex) {
    return graph.vertices().get(vertex).name();
  }

  private void addTask(int line, List<String> words, long stepMs) {
    if (words.size() != 3 && words.size() != 5) {
      throw wrong(line, String.join(" ", words), "STEP FROM TO or STEP FROM TO 0 0");
    }
    words.subList(3, words.size()).forEach(word -> whole(line, word, 0, 0));
    int last = stations.size() - 1;
    add(
        line,
        stepMs * whole(line, words.get(0), 0, LONGEST_STEP),
        stations.get(whole(line, words.get(1), 0, last)),
        stations.get(whole(line, words.get(2), 0, last)));
  }

  private void add(int line, long atMs, int from, int to) {
    if (from == to) {
      throw wrong(line, name(to), "two places that are not the same");
    }
    deliveries.add(new Delivery(atMs, from, to));
  }

  private int whole(int line, String word, int least, int most) {
    return (int) at(line, () -> Quantities.whole(word, least, most));
  }

  /** The value of a reader whose errors lack the line. */
  private long at(int line, LongSupplier reader) {
    try {
      return reader.getAsLong();
    } catch (BadInput error) {
      throw Quantities.in(file + ":" + line, error);
    }
  }

  private BadInput wrong(int line, String given, String expected) {
    return BadInput.at(file, line, BadInput.quote(given) + ": expected " + expected);
  }
}
