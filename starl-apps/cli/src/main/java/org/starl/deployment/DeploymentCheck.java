package org.starl.deployment;

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
import org.jspecify.annotations.Nullable;
import org.starl.body.MotionParameters;
import org.starl.robot.RealMotion;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.HostPort;
import org.starl.robot.file.Limits;
import org.starl.robot.file.Positions;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.Wheels;
import org.starl.robot.file.Wheels.Create;

/**
 * What can be told of a deployment without running it: whether hosts have addresses; on the machine of
 * one robot, whether its device, its address and its port are there; and, where asked, whether who
 * listens on TCP answers. Each problem is one line.
 */
public final class DeploymentCheck {

  private static final int PROBE_MS = 2000;
  private static final double MS_PER_S = 1e3;

  private final Deployment deployment;
  private final List<String> problems = new ArrayList<>();

  private DeploymentCheck(Deployment deployment) {
    this.deployment = deployment;
  }

  /**
   * Looks.
   *
   * @param here the robot whose machine this is; null for none of them
   * @param probes whether what listens on TCP is called
   * @return a line for each problem, none if all is well
   */
  public static List<String> of(Deployment deployment, @Nullable RobotEntry here, boolean probes) {
    DeploymentCheck check = new DeploymentCheck(deployment);
    check.hosts();
    if (here != null) {
      check.machine(here);
    }
    if (probes) {
      check.probe();
    }
    return List.copyOf(check.problems);
  }

  /**
   * Whether robots that move so can drive at all within the deployment's limits. That they are safe
   * needs no look: each command is checked, as it is given, with the reaction in it.
   *
   * @param motion as the app has it
   */
  public static List<String> ofMotion(Deployment deployment, MotionParameters motion) {
    DeploymentCheck check = new DeploymentCheck(deployment);
    check.motion(motion);
    return List.copyOf(check.problems);
  }

  private void motion(MotionParameters motion) {
    Limits limits = deployment.limits();
    if (limits.watchdogMs() <= motion.automatonPeriodMs()) {
      problems.add(
          deployment.where("limits")
              + "limits.watchdogMs: '"
              + limits.watchdogMs()
              + "': expected more than "
              + motion.automatonPeriodMs()
              + ", as often as a program commands its wheels");
    }
    MotionParameters real = RealMotion.of(motion, limits);
    // A command may be in effect for so long after its time, or not yet.
    double lateS = (limits.reactionMs() + motion.automatonPeriodMs()) / MS_PER_S;
    double lateMm = (1 + real.speedError()) * real.linSpeedMaxMmPerS() * lateS;
    if (errorMm(deployment.positions()) + lateMm > real.maxErrorMm()) {
      problems.add(
          deployment.where("limits")
              + "limits.reactionMs: '"
              + limits.reactionMs()
              + "': within it a robot goes "
              + Math.round(lateMm)
              + " mm; expected so little that it knows its place to within "
              + Math.round(real.maxErrorMm())
              + " mm, or a lower speedMmPerS");
    }
  }

  private static double errorMm(Positions positions) {
    return switch (positions) {
      case Positions.NatNet natNet -> natNet.errorMm();
      case Positions.JsonFeed json -> json.errorMm();
    };
  }

  private void hosts() {
    for (RobotEntry robot : deployment.robots().values()) {
      if (robot.address() != null) {
        resolve(where(robot) + "address", robot.address());
      }
      if (robot.wheels() instanceof Create create && create.port() instanceof Wheels.Tcp tcp) {
        resolve(where(robot) + "chassis.port", tcp.address());
      }
    }
    if (deployment.positions() instanceof Positions.NatNet natNet) {
      resolve(deployment.where("positions") + "positions.server", natNet.server());
      group(natNet.multicast());
    }
    if (deployment.world() != null) {
      resolve(deployment.where("world") + "world", deployment.world());
    }
  }

  private void group(@Nullable String multicast) {
    if (multicast == null) {
      return;
    }
    try {
      if (InetAddress.getByName(multicast).isMulticastAddress()) {
        return;
      }
    } catch (UnknownHostException e) {
      problems.add(
          deployment.where("positions")
              + "positions.multicast: '"
              + multicast
              + "': expected a group's address");
      return;
    }
    problems.add(
        deployment.where("positions")
            + "positions.multicast: '"
            + multicast
            + "': expected 224.0.0.0 to 239.255.255.255");
  }

  private @Nullable InetSocketAddress resolve(String where, HostPort address) {
    try {
      return address.resolve();
    } catch (UnknownHostException e) {
      problems.add(where + ": '" + address + "': expected a host that has an address");
      return null;
    }
  }

  private void machine(RobotEntry robot) {
    if (robot.wheels() instanceof Create create && create.port() instanceof Wheels.Device device) {
      Path path = Path.of(device.path());
      if (!Files.exists(path)) {
        problems.add(
            where(robot) + "chassis.port: '" + path + "': no such device; expected the Create's");
      } else if (!Files.isReadable(path) || !Files.isWritable(path)) {
        problems.add(
            where(robot)
                + "chassis.port: '"
                + path
                + "': expected a device that this user may read and write (group dialout?)");
      }
    }
    if (robot.address() == null) {
      return;
    }
    InetSocketAddress address = resolve(where(robot) + "address", robot.address());
    if (address == null) {
      return;
    }
    try {
      if (NetworkInterface.getByInetAddress(address.getAddress()) == null
          && !address.getAddress().isAnyLocalAddress()) {
        problems.add(
            where(robot) + "address: '" + address.getHostString() + "': no interface here has it");
        return;
      }
      new DatagramSocket(address).close();
    } catch (SocketException e) {
      problems.add(where(robot) + "address: '" + robot.address() + "': " + e.getMessage());
    }
  }

  private void probe() {
    if (deployment.world() != null) {
      call(deployment.where("world") + "world", deployment.world(), "'starl deploy world' there");
    }
    for (RobotEntry robot : deployment.robots().values()) {
      if (robot.wheels() instanceof Create create && create.port() instanceof Wheels.Tcp tcp) {
        call(where(robot) + "chassis.port", tcp.address(), "a Create's serial server there");
      }
    }
  }

  private void call(String where, HostPort address, String expected) {
    try (Socket socket = new Socket()) {
      socket.connect(address.resolve(), PROBE_MS);
    } catch (IOException e) {
      problems.add(where + ": '" + address + "': " + e.getMessage() + "; expected " + expected);
    }
  }

  private String where(RobotEntry robot) {
    return deployment.file() + ":" + robot.line() + ": robots." + robot.id() + ".";
  }
}
