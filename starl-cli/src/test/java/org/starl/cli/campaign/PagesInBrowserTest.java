package org.starl.cli.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.browser.Browser;
import org.starl.cli.Cli;

/** A browser shows the pages of campaigns and sweeps without an error of their scripts. */
@Tag("realtime")
class PagesInBrowserTest {

  @TempDir private Path folder;

  private Browser browser(Path page) throws Exception {
    return Browser.open(folder.resolve("profile"), page.toUri(), 1000, 800);
  }

  @Test
  void ofASweep() throws Exception {
    Path file = folder.resolve("sweep.yaml");
    Path page = folder.resolve("sweep.html");
    Files.writeString(file, "app: hello\nseeds: 1..2\nsweep: {robots: [1, 2]}\n");
    Cli cli = Cli.run("sweep", "" + file, "--report", "" + page);
    assertThat(cli.status()).as("%s", cli).isZero();
    try (Browser browser = browser(page)) {
      assertThat(browser.text("body")).contains("All 4 runs went well.");
      assertThat(browser.text("code.command + button")).isEqualTo("copy");
      assertThat(browser.errors()).isEmpty();
    }
  }

  /** The moment that a player shows. */
  private static String nowMs(int player) {
    return "Number(document.querySelectorAll('iframe')[%s].contentDocument.getElementById('time').value)"
        .formatted(player);
  }

  @Test
  void ofTwoRunsOnOneClock() throws Exception {
    Path page = folder.resolve("both.html");
    String run = "hello --seed 7 --for 5s";
    Cli cli = Cli.run("compare", run, run + " --fault 'crash(bot0,at=2s)'", "--html", "" + page);
    assertThat(cli.status()).as("%s", cli).isZero();
    try (Browser browser = browser(page)) {
      browser.await(nowMs(0) + " === 2000 && " + nowMs(1) + " === 2000");
      browser.evaluate(
          "document.querySelectorAll('iframe')[1].contentDocument.getElementById('forward').click()");
      browser.await(nowMs(0) + " === 2100 && " + nowMs(1) + " === 2100");
      browser.evaluate(
          "document.querySelectorAll('iframe')[0].contentDocument"
              + ".querySelector('#marks .DIFFERENCE').click()");
      browser.await(nowMs(1) + " === 2000");
      browser.evaluate("document.getElementById('play').click()");
      browser.await("document.getElementById('time').value > 2300");
      browser.await("document.getElementById('play').textContent === 'Play'");
      browser.await(nowMs(0) + " === " + nowMs(1));
      assertThat(browser.errors()).isEmpty();
    }
  }

  @Test
  void ofACampaignWithBadRuns() throws Exception {
    Path page = folder.resolve("campaign.html");
    Cli cli = Cli.run("campaign", "mutex", "--seeds", "1..2", "--for", "5s", "--report", "" + page);
    assertThat(cli.status()).as("%s", cli).isOne();
    try (Browser browser = browser(page)) {
      browser.evaluate(
          "told = new Set(); onmessage = event => { told.add(event.source); };"
              + "document.querySelectorAll('iframe').forEach(e => { e.srcdoc = e.srcdoc; })");
      // Both players show a moment; one that is replaced meanwhile may have told, too.
      browser.await(
          "frames.length === 2"
              + " && [...document.querySelectorAll('iframe')].every(e => told.has(e.contentWindow))");
      assertThat(browser.errors()).isEmpty();
    }
  }

  @Test
  void ofACampaign() throws Exception {
    Path page = folder.resolve("campaign.html");
    Cli cli = Cli.run("campaign", "hello", "--seeds", "1..3", "--report", "" + page);
    assertThat(cli.status()).as("%s", cli).isZero();
    try (Browser browser = browser(page)) {
      assertThat(browser.text("body")).contains("only those that did not go well (0)");
      assertThat(browser.errors()).isEmpty();
    }
  }
}
