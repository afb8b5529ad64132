package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;

/** Connections to the world's port, over the loopback interface. */
@Tag("realtime")
class RobotDoorTest {

  private static final InetAddress HOST = InetAddress.getLoopbackAddress();
  private static final RobotId BOT0 = new RobotId("bot0");

  private final List<String> lines = new CopyOnWriteArrayList<>();
  private final List<Exception> failures = new CopyOnWriteArrayList<>();
  private final BlockingQueue<String> words = new LinkedBlockingQueue<>();
  private final List<Socket> opened = new ArrayList<>();
  private ServerSocket server;
  private RobotDoor door;

  @BeforeEach
  void open() throws IOException {
    server = new ServerSocket(0, 50, HOST);
    door =
        new RobotDoor(
            server,
            BOT0::equals,
            (robot, socket, in) -> {
              while (true) {
                words.add(robot + " " + in.readUTF());
              }
            },
            new LimitedLog(() -> 1, lines::add),
            failures::add);
    door.open();
  }

  @AfterEach
  void close() throws IOException {
    door.close();
    for (Socket socket : opened) {
      socket.close();
    }
    assertThat(failures).isEmpty();
  }

  private Socket connect() throws IOException {
    Socket socket = new Socket(HOST, server.getLocalPort());
    opened.add(socket);
    return socket;
  }

  private static void send(Socket socket, String text) throws IOException {
    new DataOutputStream(socket.getOutputStream()).writeUTF(text);
  }

  private static long threads() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(thread -> thread.getName().equals("world robot"))
        .count();
  }

  @Test
  void connectionsWithoutANameTakeFewThreadsAndNoRobotsPlace() throws Exception {
    Socket robot = connect();
    send(robot, "bot0");
    send(robot, "before");
    assertThat(words.poll(60, TimeUnit.SECONDS)).isEqualTo("bot0 before");
    for (int i = 0; i < 900; i++) {
      connect();
    }
    send(robot, "after");
    assertThat(words.poll(60, TimeUnit.SECONDS)).isEqualTo("bot0 after");

    // Behind these its name arrives at once: it is served too.
    Socket again = connect();
    send(again, "bot0");
    send(again, "again");
    assertThat(words.poll(60, TimeUnit.SECONDS)).isEqualTo("bot0 again");
    // The threads of connections that were closed are about to end.
    for (int i = 0; i < 600 && threads() > RobotDoor.MAX_NAMELESS + 1; i++) {
      words.poll(100, TimeUnit.MILLISECONDS);
    }
    assertThat(threads()).isLessThanOrEqualTo(RobotDoor.MAX_NAMELESS + 1);
    assertThat(lines).filteredOn(line -> line.startsWith("more than 64 connections")).hasSize(1);
  }

  @Test
  void aRobotsLaterConnectionReplacesTheEarlierOne() throws Exception {
    Socket first = connect();
    send(first, "bot0");
    send(first, "one");
    assertThat(words.poll(60, TimeUnit.SECONDS)).isEqualTo("bot0 one");
    Socket second = connect();
    send(second, "bot0");
    send(second, "two");
    assertThat(words.poll(60, TimeUnit.SECONDS)).isEqualTo("bot0 two");
    first.setSoTimeout(60_000);
    assertThat(first.getInputStream().read()).isEqualTo(-1);
    assertThat(lines).contains("bot0 connects again: its connection before is closed");
  }

  @Test
  void unknownNamesAreRefusedAndFillNoLog() throws Exception {
    for (int i = 0; i < 50; i++) {
      Socket stranger = connect();
      stranger.setSoTimeout(60_000);
      send(stranger, i % 2 == 0 ? "bot1" : "no name");
      assertThat(stranger.getInputStream().read()).isEqualTo(-1);
    }
    assertThat(lines).hasSize(1).allMatch(line -> line.startsWith("no body for an unknown robot"));
  }
}
