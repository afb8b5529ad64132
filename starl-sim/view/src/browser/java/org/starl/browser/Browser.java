package org.starl.browser;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.File;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.jspecify.annotations.Nullable;

/**
 * A Chromium without a window, driven over its DevTools protocol: three of its methods suffice, so
 * no library with browsers of its own is needed.
 */
public final class Browser implements AutoCloseable {

  private static final List<String> NAMES =
      List.of("chromium", "chromium-browser", "google-chrome", "chrome");
  private static final String LISTENING = "DevTools listening on ";
  private static final long PATIENCE_S = 60;
  private static final Duration PATIENCE = Duration.ofSeconds(PATIENCE_S);
  private static final int MOST_ASKED = 3000;
  private static final ObjectMapper JSON = new ObjectMapper();

  private final Process process;
  private final HttpClient http = HttpClient.newHttpClient();
  private final BlockingQueue<String> answers = new LinkedBlockingQueue<>();
  private final WebSocket socket;
  private final List<String> errors = new CopyOnWriteArrayList<>();
  private int calls;

  /**
   * Opens a page. Skips the test if there is no Chromium. One that does not answer is started once
   * more, and told.
   *
   * @param profile an empty folder
   */
  public static Browser open(Path profile, URI page, int widthPx, int heightPx) throws Exception {
    try {
      return new Browser(profile, page, widthPx, heightPx);
    } catch (TimeoutException e) {
      System.err.println("a browser is started again: " + e.getMessage());
      Path another = profile.resolveSibling(profile.getFileName() + "-again");
      return new Browser(another, page, widthPx, heightPx);
    }
  }

  private Browser(Path profile, URI page, int widthPx, int heightPx) throws Exception {
    String program = program();
    assumeTrue(program != null, "skipped: no Chromium on the PATH; expected one of " + NAMES);
    process =
        new ProcessBuilder(
                String.valueOf(program),
                "--headless",
                "--no-sandbox",
                "--disable-gpu",
                "--disable-quic",
                "--no-first-run",
                "--disable-background-networking",
                "--disable-component-update",
                "--disable-sync",
                // In another process, the errors of a report's players would not be told here.
                "--disable-features=IsolateSandboxedIframes",
                "--force-device-scale-factor=1",
                "--hide-scrollbars",
                "--remote-debugging-port=0",
                "--window-size=" + widthPx + "," + heightPx,
                "--user-data-dir=" + profile,
                page.toString())
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .redirectErrorStream(false)
            .start();
    boolean isOpen = false;
    try {
      socket = connect(devTools());
      // The browser then tells also what was before.
      call("Runtime.enable", Map.of());
      call("Log.enable", Map.of());
      awaitReady();
      isOpen = true;
    } finally {
      if (!isOpen) {
        end();
      }
    }
  }

  private WebSocket connect(URI devTools) throws Exception {
    HttpRequest list =
        HttpRequest.newBuilder(URI.create("http://" + devTools.getAuthority() + "/json/list"))
            .timeout(PATIENCE)
            .build();
    JsonNode pages = JSON.readTree(http.send(list, HttpResponse.BodyHandlers.ofString()).body());
    String address = "";
    for (JsonNode each : pages) {
      if (each.path("type").asText().equals("page")) {
        address = each.path("webSocketDebuggerUrl").asText();
      }
    }
    return http.newWebSocketBuilder()
        .buildAsync(URI.create(address), new Answers())
        .get(PATIENCE_S, TimeUnit.SECONDS);
  }

  /** Asks until the page has loaded; until then the browser may show an empty one. */
  private void awaitReady() throws Exception {
    for (int asked = 0; asked < MOST_ASKED; asked++) {
      try {
        if (evaluate(
                "new Promise(done => setTimeout(() =>"
                    + " done(document.documentElement?.dataset.ready === 'true'), 20))")
            .asBoolean()) {
          return;
        }
      } catch (AssertionError replaced) {
        // The page has just replaced the empty one, whose script ended: ask again.
        continue;
      }
    }
    throw new AssertionError("the page is not ready");
  }

  private static @Nullable String program() {
    return Stream.of(System.getenv("PATH").split(File.pathSeparator, -1))
        .flatMap(folder -> NAMES.stream().map(name -> Path.of(folder, name)))
        .filter(Files::isExecutable)
        .map(Path::toString)
        .findFirst()
        .orElse(null);
  }

  /** Reads the address that the browser prints when it is ready, and goes on reading. */
  private URI devTools() throws Exception {
    CompletableFuture<URI> address = new CompletableFuture<>();
    Thread.ofVirtual().start(() -> read(process.errorReader(StandardCharsets.UTF_8), address));
    return address.get(PATIENCE_S, TimeUnit.SECONDS);
  }

  private static void read(BufferedReader reader, CompletableFuture<URI> address) {
    try (reader) {
      for (String line = reader.readLine(); line != null; line = reader.readLine()) {
        if (line.startsWith(LISTENING)) {
          address.complete(URI.create(line.substring(LISTENING.length())));
        }
      }
      address.completeExceptionally(new IOException("the browser ended without an address"));
    } catch (IOException e) {
      address.completeExceptionally(e); // of no effect if the browser was closed
    }
  }

  private final class Answers implements WebSocket.Listener {
    private final StringBuilder parts = new StringBuilder();

    @Override
    public @Nullable CompletionStage<?> onText(WebSocket from, CharSequence part, boolean isLast) {
      parts.append(part);
      if (isLast) {
        answers.add(parts.toString());
        parts.setLength(0);
      }
      from.request(1);
      return null;
    }
  }

  private JsonNode call(String method, Map<String, ?> parameters) throws Exception {
    int id = ++calls;
    Map<String, Object> call = Map.of("id", id, "method", method, "params", parameters);
    long start = System.nanoTime();
    socket.sendText(JSON.writeValueAsString(call), true).get(PATIENCE_S, TimeUnit.SECONDS);
    while (true) {
      // Events that go on and on do not make it wait longer.
      long leftNs = TimeUnit.SECONDS.toNanos(PATIENCE_S) - (System.nanoTime() - start);
      String answer = answers.poll(leftNs, TimeUnit.NANOSECONDS);
      if (answer == null) {
        throw new TimeoutException(method + " " + parameters + ": no answer in " + PATIENCE_S + " s");
      }
      JsonNode read = JSON.readTree(answer);
      note(read);
      if (read.path("id").asInt() == id) {
        if (read.has("error") || read.path("result").has("exceptionDetails")) {
          throw new AssertionError(method + " " + parameters + ": " + answer);
        }
        return read.path("result");
      }
    }
  }

  private void note(JsonNode event) {
    String method = event.path("method").asText();
    JsonNode told = event.path("params");
    boolean isError =
        method.equals("Runtime.exceptionThrown")
            || told.path("entry").path("level").asText().equals("error")
            || (method.equals("Runtime.consoleAPICalled")
                && told.path("type").asText().equals("error"));
    if (isError) {
      errors.add(told.toString());
    }
  }

  /** The errors that pages have had so far, on their console or not caught. */
  public List<String> errors() throws Exception {
    evaluate("0"); // events come in order: those before this answer are read
    return List.copyOf(errors);
  }

  /** The same, for a test that provokes them: they are forgotten. */
  public List<String> takeErrors() throws Exception {
    List<String> taken = errors();
    errors.clear();
    return taken;
  }

  /** The value of a JavaScript expression; of a promise, what it resolves to. */
  public JsonNode evaluate(String expression) throws Exception {
    Map<String, Object> parameters =
        Map.of("expression", expression, "awaitPromise", true, "returnByValue", true);
    return call("Runtime.evaluate", parameters).path("result").path("value");
  }

  /** Waits in the page, picture by picture, until a condition holds. */
  public void await(String condition) throws Exception {
    evaluate(
        "new Promise(done => { const look = () => ("
            + condition
            + ") ? done(true) :"
            + " setTimeout(look, 10); look(); })");
  }

  /** The text that the page shows at a CSS selector. */
  public String text(String selector) throws Exception {
    return evaluate("document.querySelector('" + selector + "').textContent").asText();
  }

  /** Presses and releases a key, by the browser's name of it. */
  public void key(String key) throws Exception {
    String text = key.length() == 1 ? key : "";
    call("Input.dispatchKeyEvent", Map.of("type", "keyDown", "key", key, "text", text));
    call("Input.dispatchKeyEvent", Map.of("type", "keyUp", "key", key));
  }

  public void click(double x, double y) throws Exception {
    for (String type : List.of("mousePressed", "mouseReleased")) {
      call(
          "Input.dispatchMouseEvent",
          Map.of("type", type, "x", x, "y", y, "button", "left", "clickCount", 1));
    }
  }

  public BufferedImage screenshot() throws Exception {
    String data = call("Page.captureScreenshot", Map.of()).path("data").asText();
    return ImageIO.read(new ByteArrayInputStream(Base64.getDecoder().decode(data)));
  }

  private void end() {
    List<ProcessHandle> all =
        Stream.concat(process.descendants(), Stream.of(process.toHandle())).toList();
    all.forEach(ProcessHandle::destroy);
    try {
      if (!process.waitFor(PATIENCE_S, TimeUnit.SECONDS)) {
        all.forEach(ProcessHandle::destroyForcibly);
        process.waitFor();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      all.forEach(ProcessHandle::destroyForcibly);
    }
  }

  /**
   * Ends the browser and waits for its end, so that its profile can be deleted.
   *
   * @throws AssertionError if a page has had an error, as far as its events were read
   */
  @Override
  public void close() {
    end();
    http.shutdownNow();
    if (!errors.isEmpty()) {
      throw new AssertionError("a page's console has errors: " + errors);
    }
  }
}
