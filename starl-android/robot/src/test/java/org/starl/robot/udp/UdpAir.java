package org.starl.robot.udp;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import org.starl.id.RobotId;
import org.starl.robot.contract.Ground;
import org.starl.robot.contract.RadioContract;
import org.starl.robot.contract.RealGround;

/** Robots with UDP radios on the loopback interface. */
final class UdpAir implements RadioContract.Air {

  private final List<RealGround> grounds = new ArrayList<>();
  private final List<UdpRadio> radios = new ArrayList<>();

  UdpAir() {
    for (int robot = 0; robot < ROBOTS; robot++) {
      RealGround ground = new RealGround("robot" + robot);
      grounds.add(ground);
      radios.add(open(new RobotId("robot" + robot), ground));
    }
    for (UdpRadio radio : radios) {
      for (int robot = 0; robot < ROBOTS; robot++) {
        radio.setPeer(new RobotId("robot" + robot), radios.get(robot).address());
      }
    }
  }

  private static UdpRadio open(RobotId id, RealGround ground) {
    InetSocketAddress anyPort = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
    try {
      return UdpRadio.open(id, ground.strand(), anyPort, ground.errors()::add);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public Ground ground(int robot) {
    return grounds.get(robot);
  }

  @Override
  public UdpRadio radio(int robot) {
    return radios.get(robot);
  }

  @Override
  public void closeRadio(int robot) {
    radios.get(robot).close();
  }

  @Override
  public void close() {
    radios.forEach(UdpRadio::close);
    grounds.forEach(RealGround::close);
  }
}
