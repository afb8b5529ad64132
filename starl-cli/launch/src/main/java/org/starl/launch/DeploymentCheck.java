package org.starl.launch;

import static org.starl.time.Time.NS_PER_MS;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.Socket;
import java.net.SocketException;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;
import org.starl.body.MotionParameters;
import org.starl.input.BadInput;
import org.starl.input.FailureText;
import org.starl.robot.PoseFeeds;
import org.starl.robot.RealMotion;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.HostPort;
import org.starl.robot.file.Limits;
import org.starl.robot.file.ObjectSource;
import org.starl.robot.file.Positions;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.Wheels;
import org.starl.robot.file.Wheels.Create;
import org.starl.robot.optitrack.PoseFeed;
import org.starl.robot.realtime.RealClock;
import org.starl.sim.world.FloorObjects;

/**
 * Checks a deployment without running it: whether hosts have addresses; on the machine of one
 * robot, whether its device, address and port exist; on request, whether the TCP servers and the
 * cameras answer.
 * Each problem is one line.
 */
public final class DeploymentCheck {

  private static final int CONNECT_MS = 2000;
  private static final long CAMERAS_NS = 3000 * NS_PER_MS;
  private static final double MS_PER_S = 1e3;

  private final Deployment deployment;
  private final List<String> problems = new ArrayList<>();

  private DeploymentCheck(Deployment deployment) {
    this.deployment = deployment;
  }

  /**
   * Checks hosts and machines.
   *
   * @param here the robot whose machine this is; null for none
   * @param probes whether to connect to the TCP servers, and to ask the cameras
   * @return a line for each problem
   */
  public static List<String> of(Deployment deployment, @Nullable RobotEntry here, boolean probes) {
    DeploymentCheck check = new DeploymentCheck(deployment);
    check.checkHosts(here);
    if (here != null) {
      check.checkMachine(here);
    }
    if (probes) {
      check.probe();
      check.probeCameras(here);
    }
    return List.copyOf(check.problems);
  }

  /**
   * Checks whether robots can drive at all within the deployment's limits. Safety needs no check
   * here: motion control checks each command, including the reaction time.
   *
   * @param motion as the app has it
   */
  public static List<String> ofMotion(Deployment deployment, MotionParameters motion) {
    DeploymentCheck check = new DeploymentCheck(deployment);
    check.checkMotion(motion);
    return List.copyOf(check.problems);
  }

  /**
   * Checks whether each robot has the ports that the app needs.
   *
   * @param needed the simulated robots' sensors for objects; null if the app needs none
   */
  public static List<String> ofPorts(Deployment deployment, @Nullable FloorObjects needed) {
    DeploymentCheck check = new DeploymentCheck(deployment);
    if (needed != null) {
      deployment.robots().values().forEach(robot -> check.checkObjects(robot, needed));
    }
    return List.copyOf(check.problems);
  }

  private void checkObjects(RobotEntry robot, FloorObjects needed) {
    if (robot.objects() != ObjectSource.POSITIONS) {
      problem(
          at(robot, "objects"),
          robot.objects() == null ? "" : "bumper",
          deployment.app()
              + " needs an object sensor with a range of "
              + Math.round(needed.rangeMm())
              + " mm; expected positions, which shows tagged bodies in the position feed");
    }
  }

  private void checkMotion(MotionParameters motion) {
    Limits limits = deployment.limits();
    if (limits.watchdogMs() <= motion.automatonPeriodMs()) {
      problem(
          at("limits", "watchdogMs"),
          limits.watchdogMs(),
          "expected more than "
              + motion.automatonPeriodMs()
              + ", the time between two commands of a program");
    }
    MotionParameters real = RealMotion.of(motion, limits);
    // The longest time for which an old command is still in effect.
    double lateS = (limits.reactionMs() + motion.automatonPeriodMs()) / MS_PER_S;
    double lateMm = (1 + real.speedError()) * real.linSpeedMaxMmPerS() * lateS;
    if (deployment.positions().errorMm() + lateMm > real.maxErrorMm()) {
      problem(
          at("limits", "reactionMs"),
          limits.reactionMs(),
          "within it a robot goes "
              + Math.round(lateMm)
              + " mm; expected a time in which its position error stays below "
              + Math.round(real.maxErrorMm())
              + " mm, or a lower speedMmPerS");
    }
  }

  private void checkHosts(@Nullable RobotEntry here) {
    for (RobotEntry robot : deployment.robots().values()) {
      resolve(at(robot, "address"), robot.address());
      if (robot.wheels() instanceof Create create && create.port() instanceof Wheels.Tcp tcp) {
        resolve(at(robot, "chassis.port"), tcp.address());
      }
    }
    if (deployment.positions() instanceof Positions.NatNet natNet) {
      InetSocketAddress server = resolve(at("positions", "server"), natNet.server());
      String networkInterface = natNet.networkInterface();
      if (here != null && server != null && networkInterface != null) {
        checkInterface(networkInterface, server.getAddress());
      }
    }
    resolve(deployment.where("world") + "world", deployment.world());
  }

  private void checkInterface(String at, InetAddress server) {
    try {
      PoseFeeds.addressOf(deployment, at, server);
    } catch (BadInput e) {
      problems.add(e.getMessage());
    } catch (SocketException e) {
      problem(at("positions", "interface"), at, FailureText.of(e));
    }
  }

  private @Nullable InetSocketAddress resolve(String where, @Nullable HostPort address) {
    try {
      return address == null ? null : address.resolve();
    } catch (UnknownHostException e) {
      problem(where, address, "expected a host that has an address");
      return null;
    }
  }

  private void checkMachine(RobotEntry robot) {
    if (robot.wheels() instanceof Create create && create.port() instanceof Wheels.Device device) {
      Path path = Path.of(device.path());
      if (!Files.exists(path)) {
        problem(at(robot, "chassis.port"), path, "no such device; expected the Create's");
      } else if (!Files.isReadable(path) || !Files.isWritable(path)) {
        problem(
            at(robot, "chassis.port"),
            path,
            "expected a device that this user may read and write (group dialout?)");
      }
    }
    String where = at(robot, "address");
    InetSocketAddress address = resolve(where, robot.address());
    if (address == null) {
      return;
    }
    try {
      if (NetworkInterface.getByInetAddress(address.getAddress()) == null
          && !address.getAddress().isAnyLocalAddress()) {
        problem(where, address.getHostString(), "no interface of this machine has it");
        return;
      }
      new DatagramSocket(address).close();
    } catch (SocketException e) {
      problem(where, robot.address(), e.getMessage());
    }
  }

  private void probe() {
    HostPort world = deployment.world();
    if (world != null) {
      connect(deployment.where("world") + "world", world, "'starl deploy world' there");
    }
    for (RobotEntry robot : deployment.robots().values()) {
      if (robot.wheels() instanceof Create create && create.port() instanceof Wheels.Tcp tcp) {
        connect(at(robot, "chassis.port"), tcp.address(), "a Create's serial server there");
      }
    }
  }

  /** Asks the cameras as a robot does; JSON lines come only to a robot's machine. */
  private void probeCameras(@Nullable RobotEntry here) {
    HostPort server =
        deployment.positions() instanceof Positions.NatNet natNet ? natNet.server() : null;
    if (server == null && here == null) {
      return;
    }
    String where = at("positions", server == null ? "source" : "server");
    Object source = server == null ? "json" : server;
    Set<String> missing = new ConcurrentSkipListSet<>();
    (here == null ? deployment.robots().values() : List.of(here))
        .forEach(robot -> missing.add(robot.rigidBody()));
    HostPort address = here == null ? null : here.address();
    try (PoseFeed feed =
        PoseFeeds.open(
            deployment,
            DeploymentFile.linesKey(deployment),
            address == null ? null : address.resolve().getAddress(),
            RealClock.ofDate(),
            (timeNs, level, tag, line) -> {})) {
      feed.onBodies(bodies -> bodies.forEach(body -> missing.remove(body.name())));
      long endNs = RealClock.machineNs() + CAMERAS_NS;
      while (RealClock.machineNs() < endNs && !missing.isEmpty()) {
        LockSupport.parkNanos(NS_PER_MS);
      }
      if (!missing.isEmpty()) {
        problem(where, source, "no positions of " + missing + ": " + feed.silence());
      }
    } catch (IOException e) {
      problem(where, source, e.getMessage());
    }
  }

  private void connect(String where, HostPort address, String expected) {
    try (Socket socket = new Socket()) {
      socket.connect(address.resolve(), CONNECT_MS);
    } catch (IOException e) {
      problem(where, address, e.getMessage() + "; expected " + expected);
    }
  }

  private String at(String part, String field) {
    return deployment.where(part) + part + "." + field;
  }

  private String at(RobotEntry robot, String field) {
    return deployment.file() + ":" + robot.line() + ": robots." + robot.id() + "." + field;
  }

  private void problem(String where, @Nullable Object value, @Nullable String expected) {
    problems.add(where + ": '" + value + "': " + expected);
  }
}
