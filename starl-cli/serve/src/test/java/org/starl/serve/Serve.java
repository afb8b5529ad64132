package org.starl.serve;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PipedReader;
import java.io.PipedWriter;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.starl.cli.Main;

/** {@code starl serve} with these words, until it is closed. */
final class Serve implements AutoCloseable {

  private static final Duration PATIENCE = Duration.ofMinutes(1);

  private final StringWriter err = new StringWriter();
  private final BufferedReader out;
  private final Thread command;
  private final HttpClient http = HttpClient.newHttpClient();
  final URI address;

  Serve(String... words) throws IOException {
    List<String> all = new ArrayList<>(List.of("serve", "--port", "0"));
    all.addAll(List.of(words));
    PipedWriter pipe = new PipedWriter();
    out = new BufferedReader(new PipedReader(pipe, 1 << 16));
    command =
        Thread.ofPlatform()
            .start(() -> {
              try (PrintWriter to = new PrintWriter(pipe, true)) {
                Main.run(to, new PrintWriter(err, true), all.toArray(String[]::new));
              }
            });
    String line = out.readLine();
    if (line == null) {
      throw new AssertionError("did not start: " + err);
    }
    address = URI.create(line.split(" ", 2)[0]);
  }

  URI at(String path) {
    return address.resolve(path);
  }

  HttpResponse<String> get(String path, String... headers)
      throws IOException, InterruptedException {
    HttpRequest.Builder request = HttpRequest.newBuilder(at(path)).timeout(PATIENCE);
    if (headers.length > 0) {
      request.headers(headers);
    }
    return http.send(request.build(), HttpResponse.BodyHandlers.ofString());
  }

  HttpResponse<String> post(String path, String body) throws IOException, InterruptedException {
    HttpRequest request =
        HttpRequest.newBuilder(at(path))
            .timeout(PATIENCE)
            .POST(HttpRequest.BodyPublishers.ofString(body))
            .build();
    return http.send(request, HttpResponse.BodyHandlers.ofString());
  }

  /** Sends a request as it is, and leaves the answer to the caller. */
  Socket ask(String request) throws IOException {
    Socket socket = new Socket(address.getHost(), address.getPort());
    socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
    return socket;
  }

  /** What the command wrote to standard error; all of it once it is closed. */
  String errors() {
    return err.toString();
  }

  @Override
  public void close() {
    command.interrupt();
    try {
      if (!command.join(PATIENCE)) {
        throw new AssertionError(
            "the command goes on: " + Arrays.toString(command.getStackTrace()));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new AssertionError("interrupted while the command ends", e);
    } finally {
      http.shutdownNow();
    }
  }
}
