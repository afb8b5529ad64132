package org.starl.bench;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.starl.apps.intersection.IntersectionDemo;
import org.starl.apps.intersection.logic.Route;
import org.starl.apps.intersection.robot.Car;
import org.starl.time.Time;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.SAXException;

/**
 * The same arrivals in SUMO, a simulator of road traffic, if its programs {@code netconvert} and
 * {@code sumo} are on the PATH: an actuated traffic light, and an all-way stop. Lengths and speeds are {@link #SCALE} times ours, so that a car of
 * 330 mm is one of 5 m; times are the same. SUMO's cars keep 1.5 m (99 mm here) and 1 s apart. They
 * need not turn on the spot, and bodies may touch zones that we keep free.
 */
final class Sumo {

  /** Who may enter. */
  enum Control {
    LIGHT("traffic_light"),
    STOP("allway_stop");

    private final String type;

    Control(String type) {
      this.type = type;
    }
  }

  private static final double SCALE = 5 / 0.33;
  private static final double SPEED_M_PER_S = 0.25 * SCALE;
  private static final double LANE_M = 0.5 * SCALE;
  // Half of our floor: cars wait beyond the road's edge, as ours.
  private static final double ARM_M = 2.5 * SCALE;
  private static final int END_S = 3_000;

  private final Path netconvert;
  private final Path sumo;

  private Sumo(Path netconvert, Path sumo) {
    this.netconvert = netconvert;
    this.sumo = sumo;
  }

  /** SUMO, if it is on the PATH. */
  static Optional<Sumo> find() {
    return onPath("netconvert").flatMap(first -> onPath("sumo").map(then -> new Sumo(first, then)));
  }

  private static Optional<Path> onPath(String program) {
    return Arrays.stream(System.getenv().getOrDefault("PATH", "").split(File.pathSeparator))
        .map(folder -> Path.of(folder, program))
        .filter(Files::isExecutable)
        .findFirst();
  }

  /** Runs the cars of {@link CrossingRules} with this seed. */
  CrossingRules.Flow run(Control control, int ratePerMin, Duration arrivals, long seed) {
    List<Car> cars = IntersectionDemo.arrivals(ratePerMin / 60.0, arrivals, seed);
    try {
      Path folder = Files.createTempDirectory("starl-sumo");
      try {
        return flow(folder, control, cars, arrivals);
      } finally {
        delete(folder);
      }
    } catch (IOException e) {
      throw new UncheckedIOException("SUMO: " + e.getMessage(), e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("SUMO: interrupted", e);
    }
  }

  private CrossingRules.Flow flow(Path folder, Control control, List<Car> cars, Duration arrivals)
      throws IOException, InterruptedException {
    Files.writeString(folder.resolve("nodes.xml"), nodes(control));
    Files.writeString(folder.resolve("edges.xml"), edges());
    Files.writeString(folder.resolve("cars.xml"), vehicles(cars));
    execute(
        folder,
        netconvert,
        "-n nodes.xml -e edges.xml -o net.xml --no-turnarounds true --tls.default-type actuated"
            + " --junctions.limit-turn-speed -1");
    String warnings =
        execute(
            folder,
            sumo,
            "-n net.xml -r cars.xml --tripinfo-output trips.xml --step-length 0.1 --time-to-teleport -1"
                + " --no-step-log true --duration-log.disable true --collision.action warn --end "
                + END_S);
    NodeList trips = elements(folder.resolve("trips.xml"));
    Set<String> crossed = new HashSet<>();
    int inTime = 0;
    double delayS = 0;
    for (int i = 0; i < trips.getLength(); i++) {
      Element trip = (Element) trips.item(i);
      inTime += number(trip, "arrival") <= arrivals.toSeconds() ? 1 : 0;
      delayS += number(trip, "departDelay") + number(trip, "timeLoss");
      crossed.add(trip.getAttribute("id"));
    }
    // SUMO's cars may block each other for ever: one that has not crossed has waited until the end.
    for (Car car : cars) {
      delayS += crossed.contains(car.id().name()) ? 0 : END_S - Time.seconds(car.readyNs());
    }
    int contacts = (int) warnings.lines().filter(line -> line.contains("collision")).count();
    double meanS = delayS / Math.max(1, cars.size());
    return new CrossingRules.Flow(cars.size(), inTime, meanS, 0, contacts, trips.getLength(), 0);
  }

  private static double number(Element trip, String attribute) {
    return Double.parseDouble(trip.getAttribute(attribute));
  }

  private static String nodes(Control control) {
    return "<nodes>"
        + "<node id='c' x='0' y='0' type='%s'/>".formatted(control.type)
        + arm("N", 0, ARM_M)
        + arm("E", ARM_M, 0)
        + arm("S", 0, -ARM_M)
        + arm("W", -ARM_M, 0)
        + "</nodes>";
  }

  private static String arm(String name, double x, double y) {
    return String.format(
        Locale.ROOT, "<node id='%s' x='%.1f' y='%.1f' type='priority'/>", name, x, y);
  }

  private static String edges() {
    StringBuilder edges = new StringBuilder("<edges>");
    for (String arm : List.of("N", "E", "S", "W")) {
      edges.append(edge("in" + arm, arm, "c")).append(edge("out" + arm, "c", arm));
    }
    return edges.append("</edges>").toString();
  }

  private static String edge(String id, String from, String to) {
    return String.format(
        Locale.ROOT,
        "<edge id='%s' from='%s' to='%s' numLanes='1' speed='%.4f' width='%.3f'/>",
        id,
        from,
        to,
        SPEED_M_PER_S,
        LANE_M);
  }

  private static String vehicles(List<Car> cars) {
    StringBuilder all = new StringBuilder("<routes>");
    all.append(
        String.format(
            Locale.ROOT,
            "<vType id='car' length='5' width='5' minGap='1.5' tau='1' sigma='0' accel='2.6' decel='4.5'"
                + " emergencyDecel='9' maxSpeed='%.4f' speedFactor='1' speedDev='0'/>",
            SPEED_M_PER_S));
    for (Car car : cars) {
      Route route = car.trip().route().orElseThrow();
      all.append(
          String.format(
              Locale.ROOT,
              "<vehicle id='%s' type='car' depart='%.3f' departSpeed='max' departPos='0'>"
                  + "<route edges='in%s out%s'/></vehicle>",
              car.id(),
              (double) car.readyNs() / Time.NS_PER_S,
              arm(route.arrival()),
              arm(route.departure())));
    }
    return all.append("</routes>").toString();
  }

  /** Where the arm of a zone lies: A is in the north-west, and cars keep to the right. */
  private static String arm(String zone) {
    return switch (zone) {
      case "A0", "B1" -> "N";
      case "B0", "D1" -> "E";
      case "D0", "C1" -> "S";
      case "C0", "A1" -> "W";
      default ->
          throw new IllegalArgumentException(zone + ": expected an arrival or departure zone");
    };
  }

  /** Runs a program in a folder; its output. */
  private static String execute(Path folder, Path program, String words)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(program.toString()));
    command.addAll(List.of(words.split(" ")));
    Path output = folder.resolve("output.txt");
    Process process =
        new ProcessBuilder(command)
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    int status = process.waitFor();
    String text = Files.readString(output);
    if (status != 0) {
      throw new IOException(program + " ended with status " + status + ": " + text.strip());
    }
    return text;
  }

  private static NodeList elements(Path file) throws IOException {
    try {
      return DocumentBuilderFactory.newDefaultInstance()
          .newDocumentBuilder()
          .parse(file.toFile())
          .getElementsByTagName("tripinfo");
    } catch (ParserConfigurationException | SAXException e) {
      throw new IOException(file + ": " + e.getMessage(), e);
    }
  }

  private static void delete(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(file);
      }
    }
  }
}
