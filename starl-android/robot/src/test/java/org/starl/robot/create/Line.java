package org.starl.robot.create;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import org.starl.robot.serial.PseudoTerminal;
import org.starl.robot.serial.SerialLink;

/** A kind of line between a driver and a simulated robot. */
enum Line implements LiveRobot.Joint {
  MEMORY {
    @Override
    public ByteLink.Source join(CreateHost host) {
      return () -> {
        MemoryLink[] ends = MemoryLink.pair();
        host.serve(ends[1]);
        return ends[0];
      };
    }
  },
  SOCKET {
    @Override
    public ByteLink.Source join(CreateHost host) {
      try {
        ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        host.listen(server);
        return SocketLink.to(server.getInetAddress().getHostAddress(), server.getLocalPort());
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  },
  PSEUDO_TERMINAL {
    @Override
    public ByteLink.Source join(CreateHost host) {
      try {
        StreamLink terminal = PseudoTerminal.open("");
        host.serve(terminal);
        return SerialLink.at(terminal.name(), CreateModel.CREATE_2.baud());
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  };
}
