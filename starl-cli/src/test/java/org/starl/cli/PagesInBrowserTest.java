package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A browser shows the pages of campaigns and sweeps without an error of their scripts. */
@Tag("realtime")
class PagesInBrowserTest {

  private static final List<String> NAMES =
      List.of("chromium", "chromium-browser", "google-chrome", "chrome");

  @TempDir private Path folder;

  /** Fails on a line that the page writes to the console; returns the page as it then is. */
  private String shown(Path page) throws Exception {
    Path program =
        Stream.of(System.getenv("PATH").split(File.pathSeparator, -1))
            .flatMap(each -> NAMES.stream().map(name -> Path.of(each, name)))
            .filter(Files::isExecutable)
            .findFirst()
            .orElse(null);
    assumeTrue(program != null, "skipped: no Chromium on the PATH; expected one of " + NAMES);
    Path log = folder.resolve("log");
    Process browser =
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
                "--enable-logging=stderr",
                "--user-data-dir=" + folder.resolve("profile"),
                "--dump-dom",
                page.toUri().toString())
            .redirectError(log.toFile())
            .start();
    String dom = new String(browser.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    browser.waitFor();
    assertThat(Files.readString(log).lines().filter(line -> line.contains("CONSOLE"))).isEmpty();
    return dom;
  }

  @Test
  void ofASweep() throws Exception {
    Path file = folder.resolve("sweep.yaml");
    Path page = folder.resolve("sweep.html");
    Files.writeString(file, "app: hello\nseeds: 1..2\nsweep: {robots: [1, 2]}\n");
    Cli cli = Cli.run("sweep", "" + file, "--report", "" + page);
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(shown(page))
        .contains("All 4 runs went well.", "<button type=\"button\">copy</button>");
  }

  @Test
  void ofACampaign() throws Exception {
    Path page = folder.resolve("campaign.html");
    Cli cli = Cli.run("campaign", "hello", "--seeds", "1..3", "--report", "" + page);
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(shown(page)).contains("only those that did not go well (0)");
  }
}
