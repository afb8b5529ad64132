package org.starl.robot.file;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.robot.file.Wheels.Create;
import org.starl.robot.file.Wheels.Port;

/** Makes a {@link Deployment} of a file's tree. */
public final class DeploymentReader {

  private static final int COMMAND_PORT = 1510;
  private static final int CREATE1_BAUD = 57_600;
  private static final int CREATE2_BAUD = 115_200;

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
        .deployment(Fields.of(file, "deployment", root, Grammar.FILE.expected()));
  }

  private Deployment deployment(Fields top) {
    // Errors name parts of the top without a path.
    Fields fields = Fields.of(file, "", new Node.Mapping(top.line(), top.parts()), "");
    Map<String, Integer> lines = new LinkedHashMap<>();
    for (Field field :
        List.of(Grammar.APP, Grammar.KEY, Grammar.POSITIONS, Grammar.WORLD, Grammar.LIMITS)) {
      lines.put(field.key(), fields.line(field.key()));
    }
    String app = fields.text(Grammar.APP);
    String key = fields.textOrNull(Grammar.KEY);
    long seed = fields.wholeLong(Grammar.SEED);
    Map<String, String> parameters = parameters(fields, lines);
    Network network = network(fields);
    Positions positions = positions(fields);
    Limits limits = limits(fields);
    HostPort world = fields.addressOrNull(Grammar.WORLD, 0);
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
    Fields given = fields.linesOrNone(Grammar.PARAMETERS);
    for (String name : given.parts().keySet()) {
      parameters.put(name, given.value(name));
      lines.put(name, given.line(name));
    }
    return parameters;
  }

  private static Network network(Fields fields) {
    Fields given = fields.linesOrNone(Grammar.NETWORK);
    Network network =
        new Network(
            given.whole(Grammar.RADIO_PORT),
            given.yesNo(Grammar.BROADCASTS),
            given.whole(Grammar.BEACON_EVERY_MS),
            given.whole(Grammar.SUSPECT_AFTER_MS),
            given.amount(Grammar.LOSS));
    given.end();
    if (network.suspectAfterMs() < 2 * network.beaconEveryMs()) {
      throw given.wrong(
          Grammar.SUSPECT_AFTER_MS.key(),
          Integer.toString(network.suspectAfterMs()),
          "at least twice beaconEveryMs, which is " + network.beaconEveryMs());
    }
    return network;
  }

  private static Positions positions(Fields fields) {
    Fields given = fields.lines(Grammar.POSITIONS);
    Positions positions =
        given.choice(Grammar.SOURCE).equals(Grammar.NATNET)
            ? natNet(given)
            : new Positions.JsonFeed(
                given.whole(Grammar.JSON_PORT),
                given.textOrNull(Grammar.SENDER),
                given.amount(Grammar.ERROR_MM),
                given.amount(Grammar.ERROR_RAD));
    given.end();
    return positions;
  }

  private static Positions natNet(Fields given) {
    HostPort server = given.addressOrNull(Grammar.SERVER, COMMAND_PORT);
    if (server == null) {
      throw given.lacking(Grammar.SERVER);
    }
    return new Positions.NatNet(
        server,
        given.whole(Grammar.DATA_PORT),
        given.textOrNull(Grammar.MULTICAST),
        given.choice(Grammar.VERSION),
        given.choice(Grammar.UP).equals("y"),
        given.amount(Grammar.ERROR_MM),
        given.amount(Grammar.ERROR_RAD));
  }

  private static Limits limits(Fields fields) {
    Fields given = fields.linesOrNone(Grammar.LIMITS);
    Limits limits =
        new Limits(
            given.amount(Grammar.SPEED_MM_PER_S),
            given.whole(Grammar.WATCHDOG_MS),
            given.whole(Grammar.POSITION_MS),
            given.amount(Grammar.SPEED_ERROR),
            given.whole(Grammar.REACTION_MS));
    given.end();
    return limits;
  }

  private SortedMap<RobotId, RobotEntry> robots(Fields fields, Network network) {
    Fields given = fields.lines(Grammar.ROBOTS);
    Form.Lines each = ((Form.Named) Grammar.ROBOTS.form()).each();
    SortedMap<RobotId, RobotEntry> robots = new TreeMap<>();
    for (String name : given.parts().keySet()) {
      if (!RobotId.isValid(name)) {
        throw given.wrong(name, name, "a name: a letter, then up to 31 of A-Z a-z 0-9 _ - .");
      }
      Fields robot = given.lines(name, each);
      RobotId id = new RobotId(name);
      String rigidBody = robot.textOrNull(Grammar.RIGID_BODY);
      robots.put(
          id,
          new RobotEntry(
              id,
              given.line(name),
              robot.addressOrNull(Grammar.ADDRESS, network.port()),
              wheels(robot),
              rigidBody == null ? name : rigidBody));
      robot.end();
    }
    if (robots.isEmpty()) {
      throw fields.wrong(Grammar.ROBOTS.key(), "", "at least one robot");
    }
    return robots;
  }

  private static Wheels wheels(Fields robot) {
    Fields given = robot.lines(Grammar.CHASSIS);
    boolean isSimulated = given.choice(Grammar.KIND).equals(Grammar.SIMULATED);
    Wheels wheels = isSimulated ? new Wheels.Simulated() : create(given);
    given.end();
    return wheels;
  }

  private static Wheels create(Fields given) {
    String model = given.choice(Grammar.MODEL);
    int usualBaud = model.equals("create1") ? CREATE1_BAUD : CREATE2_BAUD;
    Port port = port(given, Grammar.PORT, given.text(Grammar.PORT));
    String simulatedAt = given.textOrNull(Grammar.SIMULATED_AT);
    return new Create(
        model,
        port,
        given.wholeOr(Grammar.BAUD, usualBaud),
        simulatedAt == null ? null : port(given, Grammar.SIMULATED_AT, simulatedAt));
  }

  private static Port port(Fields given, Field field, String text) {
    return text.startsWith("tcp:")
        ? new Wheels.Tcp(given.address(field.key(), text.substring("tcp:".length()), 0))
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
          Grammar.KEY.key(),
          "the path of a key, or network.broadcasts: no: strangers must not be let in");
    }
  }

  private void refuseSimulation(Deployment deployment, RobotEntry robot) {
    boolean isSimulated = deployment.simulated().contains(robot);
    if (isSimulated && deployment.world() == null) {
      throw at(robot, "is simulated; expected 'world: HOST:PORT', where its body is");
    }
    if (isSimulated && !(deployment.positions() instanceof Positions.NatNet)) {
      throw at(robot, "is simulated; expected positions.source natnet, which its world speaks");
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
