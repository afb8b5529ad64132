package org.starl.deployment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.InputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.starl.deploy.create.ByteLink;
import org.starl.deploy.file.HostPort;
import org.starl.deploy.file.Wheels;

/** The process between a robot's program and its wheels. */
class WheelGuardTest {

  private static final byte[] STAND = {(byte) 145, 0, 0, 0, 0};

  @Test
  void itPassesBytesBothWaysAndMakesTheCreateStandWhenTheProgramIsGone() throws Exception {
    try (ServerSocket create = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      HostPort address = new HostPort("127.0.0.1", create.getLocalPort());
      ByteLink program = WheelGuard.source(new Wheels.Tcp(address), 115_200).open();
      try (Socket line = create.accept()) {
        program.output().write("drive".getBytes(StandardCharsets.US_ASCII));
        program.output().flush();
        line.getOutputStream().write("bump".getBytes(StandardCharsets.US_ASCII));
        InputStream said = line.getInputStream();

        assertThat(said.readNBytes(5)).asString(StandardCharsets.US_ASCII).isEqualTo("drive");
        assertThat(program.input().readNBytes(4))
            .asString(StandardCharsets.US_ASCII)
            .isEqualTo("bump");

        // As the end of the program's process does.
        program.output().close();

        assertThat(said.readNBytes(STAND.length)).isEqualTo(STAND);
        program.close();
      }
    }
  }
}
