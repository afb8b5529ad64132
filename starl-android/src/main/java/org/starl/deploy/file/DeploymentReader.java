package org.starl.deploy.file;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.RobotId;
import org.starl.deploy.file.Wheels.Create;
import org.starl.deploy.file.Wheels.Port;

/** Makes a {@link Deployment} of a file's tree. */
public final class DeploymentReader {

  private static final int USUAL_PORT = 4747;
  private static final int USUAL_COMMAND_PORT = 1510;
  private static final int USUAL_DATA_PORT = 1511;
  private static final int USUAL_JSON_PORT = 1520;
  private static final int CREATE1_BAUD = 57_600;
  private static final int CREATE2_BAUD = 115_200;
  private static final double USUAL_ERROR_MM = 5;
  private static final double USUAL_ERROR_RAD = 0.02;
  private static final int HOUR_MS = 3_600_000;

  private static final String APP = "app";
  private static final String KEY = "key";
  private static final String SIMULATED = "simulated";

  private final String file;

  private DeploymentReader(String file) {
    this.file = file;
  }

  /**
   * @param file its name, for messages
   * @throws DeploymentException if a part is missing, unknown, out of its range, or contradicts another
   */
  public static Deployment read(String file, Node root) {
    return new DeploymentReader(file)
        .deployment(Fields.of(file, "deployment", root, "lines such as 'app: intersection'"));
  }

  private Deployment deployment(Fields top) {
    // Errors name parts of the top without a path.
    Fields fields = Fields.of(file, "", new Node.Mapping(top.line(), top.parts()), "");
    Map<String, Integer> lines = new LinkedHashMap<>();
    String app = fields.text(APP, "an app of 'starl list'");
    lines.put(APP, fields.line(APP));
    String key = fields.textOrNull(KEY, "the path of a key, as 'starl keygen' makes it");
    lines.put(KEY, fields.line(KEY));
    lines.put("positions", fields.line("positions"));
    lines.put("world", fields.line("world"));
    long seed = fields.wholeLong("seed", 0L, Long.MIN_VALUE, Long.MAX_VALUE);
    Map<String, String> parameters = parameters(fields, lines);
    Network network = network(fields);
    Positions positions = positions(fields);
    Limits limits = limits(fields);
    HostPort world = fields.addressOrNull("world", 0);
    SortedMap<RobotId, RobotEntry> robots = robots(fields, network);
    fields.end();
    Deployment deployment =
        new Deployment(
            file, app, seed, parameters, lines, key, network, positions, robots, world, limits);
    refuseContradictions(fields, deployment);
    return deployment;
  }

  private static Map<String, String> parameters(Fields fields, Map<String, Integer> lines) {
    Map<String, String> parameters = new LinkedHashMap<>();
    Fields given = fields.mappingOrNull("parameters", "lines such as 'scenario: figure7'");
    if (given != null) {
      for (String name : given.parts().keySet()) {
        parameters.put(name, given.text(name, "one value"));
        lines.put(name, given.line(name));
      }
    }
    return parameters;
  }

  private static Network network(Fields fields) {
    Fields given = fields.mappingOrNull("network", "lines such as 'port: 4747'");
    if (given == null) {
      return new Network(USUAL_PORT, true, 1000, 3000, 0);
    }
    Network network =
        new Network(
            given.whole("port", USUAL_PORT, 1, HostPort.MAX_PORT),
            given.yesNo("broadcasts", true),
            given.whole("beaconEveryMs", 1000, 50, HOUR_MS),
            given.whole("suspectAfterMs", 3000, 100, HOUR_MS),
            given.number("loss", 0, 0, 1));
    given.end();
    if (network.suspectAfterMs() < 2 * network.beaconEveryMs()) {
      throw given.wrong(
          "suspectAfterMs",
          Integer.toString(network.suspectAfterMs()),
          "at least twice beaconEveryMs, which is " + network.beaconEveryMs());
    }
    return network;
  }

  private static Positions positions(Fields fields) {
    Fields given = fields.mapping("positions", "lines such as 'source: natnet'");
    String source = given.choice("source", null, "natnet", "json");
    Positions positions =
        source.equals("natnet")
            ? natNet(given)
            : new Positions.JsonFeed(
                given.whole("port", USUAL_JSON_PORT, 1, HostPort.MAX_PORT),
                given.textOrNull("sender", "a host whose lines are taken"),
                errorMm(given),
                errorRad(given));
    given.end();
    return positions;
  }

  private static Positions natNet(Fields given) {
    String version = given.choice("version", "4.1", "3.0", "3.1", "4.0", "4.1", "4.2");
    HostPort server = given.addressOrNull("server", USUAL_COMMAND_PORT);
    if (server == null) {
      throw given.lacking("server", "the address of the NatNet server");
    }
    return new Positions.NatNet(
        server,
        given.whole("dataPort", USUAL_DATA_PORT, 1, HostPort.MAX_PORT),
        given.textOrNull("multicast", "a group such as 239.255.42.99"),
        version,
        given.choice("up", "y", "y", "z").equals("y"),
        errorMm(given),
        errorRad(given));
  }

  private static double errorMm(Fields given) {
    return given.number("errorMm", USUAL_ERROR_MM, 0, 1000);
  }

  private static double errorRad(Fields given) {
    return given.number("errorRad", USUAL_ERROR_RAD, 0, 3);
  }

  private static Limits limits(Fields fields) {
    Fields given = fields.mappingOrNull("limits", "lines such as 'watchdogMs: 200'");
    if (given == null) {
      return new Limits(500, 200, 500);
    }
    Limits limits =
        new Limits(
            given.number("speedMmPerS", 500, 1, 500),
            given.whole("watchdogMs", 200, 20, 10_000),
            given.whole("positionMs", 500, 20, 60_000));
    given.end();
    return limits;
  }

  private SortedMap<RobotId, RobotEntry> robots(Fields fields, Network network) {
    Fields given =
        fields.mapping("robots", "a robot's name, and beneath it its address and chassis");
    SortedMap<RobotId, RobotEntry> robots = new TreeMap<>();
    for (String name : given.parts().keySet()) {
      if (!RobotId.isValid(name)) {
        throw given.wrong(name, name, "a name: a letter, then up to 31 of A-Z a-z 0-9 _ - .");
      }
      Fields robot = given.mapping(name, "lines such as 'address: 192.168.1.10'");
      RobotId id = new RobotId(name);
      String rigidBody = robot.textOrNull("rigidBody", "the rigid body's name");
      robots.put(
          id,
          new RobotEntry(
              id,
              given.line(name),
              robot.addressOrNull("address", network.port()),
              wheels(robot),
              rigidBody == null ? name : rigidBody));
      robot.end();
    }
    if (robots.isEmpty()) {
      throw fields.wrong("robots", "", "at least one robot");
    }
    return robots;
  }

  private static Wheels wheels(Fields robot) {
    Fields given = robot.mapping("chassis", "lines such as 'kind: create'");
    String kind = given.choice("kind", null, "create", SIMULATED);
    Wheels wheels = kind.equals(SIMULATED) ? new Wheels.Simulated() : create(given);
    given.end();
    return wheels;
  }

  private static Wheels create(Fields given) {
    String model = given.choice("model", "create2", "create1", "create2");
    int usualBaud = model.equals("create1") ? CREATE1_BAUD : CREATE2_BAUD;
    Port port = port(given, "port", given.text("port", "a device or tcp:HOST:PORT"));
    String simulatedAt = given.textOrNull("simulatedAt", "a device or tcp:HOST:PORT");
    return new Create(
        model,
        port,
        given.whole("baud", usualBaud, 300, 3_000_000),
        simulatedAt == null ? null : port(given, "simulatedAt", simulatedAt));
  }

  private static Port port(Fields given, String key, String text) {
    return text.startsWith("tcp:")
        ? new Wheels.Tcp(given.address(key, text.substring("tcp:".length()), 0))
        : new Wheels.Device(text);
  }

  private void refuseContradictions(Fields fields, Deployment deployment) {
    Map<String, RobotEntry> addresses = new LinkedHashMap<>();
    Map<String, RobotEntry> ports = new LinkedHashMap<>();
    Map<String, RobotEntry> bodies = new LinkedHashMap<>();
    for (RobotEntry robot : deployment.robots().values()) {
      if (robot.address() != null) {
        once(addresses, "address", robot.address().toString(), robot);
      } else if (!deployment.network().broadcasts()) {
        throw at(robot, "has no address, and network.broadcasts is off; expected one of the two");
      }
      if (robot.wheels() instanceof Create create) {
        // A device is its machine's own: elsewhere another may be called so.
        String machine =
            create.port() instanceof Wheels.Tcp
                ? ""
                : robot.address() == null ? " of " + robot.id() : " of " + robot.address().host();
        once(ports, "chassis.port", create.port() + machine, robot);
      }
      once(bodies, "rigidBody", robot.rigidBody(), robot);
      refuseSimulation(deployment, robot);
    }
    if (deployment.key() == null && deployment.network().broadcasts()) {
      throw fields.lacking(
          KEY, "the path of a key, or network.broadcasts: no: strangers must not be let in");
    }
  }

  private void refuseSimulation(Deployment deployment, RobotEntry robot) {
    boolean isSimulated = deployment.simulated().contains(robot);
    if (isSimulated && deployment.world() == null) {
      throw at(robot, "is simulated; expected 'world: HOST:PORT', where its body is");
    }
  }

  private void once(Map<String, RobotEntry> taken, String key, String value, RobotEntry robot) {
    RobotEntry other = taken.put(value, robot);
    if (other != null) {
      throw at(
          robot, key + ": '" + value + "': expected another one, which " + other.id() + " has not");
    }
  }

  private DeploymentException at(RobotEntry robot, @Nullable String what) {
    return new DeploymentException(
        file + ":" + robot.line() + ": robots." + robot.id() + ": " + what);
  }
}
