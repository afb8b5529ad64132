package org.starl.sim.view.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;
import org.starl.browser.Browser;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.sim.record.Layer;
import org.starl.sim.replay.Recording;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

/** The page of 50 robots: one is found by its name, and the list is one stop of the tab key. */
@Tag("realtime")
class ManyRobotsPageTest {

  private static final int ROBOTS = 50;
  private static final String STOPS =
      "[...document.querySelectorAll('#robots button')].filter(each => each.tabIndex === 0)";
  private static final String FOCUSED = "document.activeElement.textContent.trim()";

  @TempDir(cleanup = CleanupMode.ON_SUCCESS)
  private Path folder;

  private Browser browser(int robots, int widthPx, int heightPx) throws Exception {
    List<RobotId> ids = new ArrayList<>();
    for (int i = 0; i < robots; i++) {
      ids.add(new RobotId("bot" + i));
    }
    Recording run = new Recording(Obstacles.of(), Layer.NONE);
    run.started(new TraceHeader("0", "many", 7, 8, Map.of(), ids));
    for (int i = 0; i < robots; i++) {
      Point at = new Point(i % 10 * 500, i / 10 * 500);
      run.observed(new TraceEvent.Joined(0, ids.get(i), Pose.of(at, 0), 165));
    }
    run.over(1_000_000_000);
    Path page = folder.resolve("run.html");
    try (OutputStream out = Files.newOutputStream(page)) {
      new RunPage(run).write(out);
    }
    return Browser.open(
        Files.createDirectory(folder.resolve("profile")), page.toUri(), widthPx, heightPx);
  }

  private static List<String> listed(Browser browser) throws Exception {
    List<String> names = new ArrayList<>();
    browser
        .evaluate(
            "[...document.querySelectorAll('#robots b')].filter(b => b.offsetParent)"
                + ".map(b => b.textContent)")
        .forEach(name -> names.add(name.asText()));
    return names;
  }

  @Test
  void aRobotIsFoundByItsName() throws Exception {
    Browser browser = browser(ROBOTS, 1200, 860);
    browser.evaluate("document.getElementById('find').focus()");
    browser.key("T");
    browser.key("4");
    assertThat(listed(browser))
        .containsExactly(
            "bot4", "bot40", "bot41", "bot42", "bot43", "bot44", "bot45", "bot46", "bot47", "bot48",
            "bot49");
    browser.key("d"); // a letter of the field, not the page's key for its theme
    assertThat(listed(browser)).isEmpty();
    assertThat(browser.evaluate("document.documentElement.dataset.theme").asText())
        .isEqualTo("light");
    browser.close();
  }

  @Test
  void theListIsOneStopAndArrowsLeadThroughIt() throws Exception {
    Browser browser = browser(ROBOTS, 1200, 860);
    assertThat(browser.evaluate(STOPS + ".length").asInt()).isEqualTo(1);
    browser.evaluate(STOPS + "[0].focus()");
    browser.key("ArrowDown");
    browser.key("ArrowDown");
    assertThat(browser.evaluate(FOCUSED).asText()).isEqualTo("bot2");
    assertThat(browser.text("#selected")).isEqualTo("bot2");
    browser.key("End");
    assertThat(browser.text("#selected")).isEqualTo("bot49");
    browser.key("ArrowUp");
    browser.key("Tab");
    assertThat(browser.evaluate("document.activeElement.closest('#robots') === null").asBoolean())
        .isTrue();
    assertThat(browser.text("#selected")).isEqualTo("bot48");
    assertThat(browser.evaluate("document.getElementById('time').value").asText()).isEqualTo("0");
    browser.close();
  }

  @Test
  void fewRobotsNeedNoSearch() throws Exception {
    Browser browser = browser(3, 1200, 860);
    assertThat(browser.evaluate("document.getElementById('find').hidden").asBoolean()).isTrue();
    browser.close();
  }

  @Test
  void onASmallScreenPlayIsInSight() throws Exception {
    Browser browser = browser(ROBOTS, 500, 800);
    assertThat(
            browser
                .evaluate(
                    "(r => r.top >= 0 && r.bottom <= innerHeight)"
                        + "(document.getElementById('play').getBoundingClientRect())")
                .asBoolean())
        .isTrue();
    browser.close();
  }
}
