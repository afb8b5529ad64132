package org.starl.sim.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.sim.fault.FaultGrammar;
import org.starl.sim.record.Theme;
import org.starl.sim.replay.Recording;
import org.starl.sim.replay.TraceLoader;

/** Builds, lays out and paints the window in memory, without a screen. */
class ContentTest {

  private static final int WIDTH_PX = 1200;
  private static final int HEIGHT_PX = 800;

  private static Recording recording() {
    return Runs.plain()
        .says(Runs.SECOND_NS, Runs.A, "WAIT")
        .violates(2 * Runs.SECOND_NS, "Exclusive")
        .over(10 * Runs.SECOND_NS);
  }

  private static void layOut(Component component) {
    component.doLayout();
    if (component instanceof Container container) {
      for (Component child : container.getComponents()) {
        layOut(child);
      }
    }
  }

  private static BufferedImage painted(Content content) {
    content.panel().setSize(WIDTH_PX, HEIGHT_PX);
    layOut(content.panel());
    content.read();
    layOut(content.panel());
    BufferedImage image = new BufferedImage(WIDTH_PX, HEIGHT_PX, BufferedImage.TYPE_INT_RGB);
    Graphics2D page = image.createGraphics();
    content.panel().paint(page);
    page.dispose();
    return image;
  }

  private static Set<Integer> colours(BufferedImage image) {
    Set<Integer> colours = new TreeSet<>();
    for (int y = 0; y < image.getHeight(); y++) {
      for (int x = 0; x < image.getWidth(); x++) {
        colours.add(image.getRGB(x, y) & 0xFFFFFF);
      }
    }
    return colours;
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void everythingIsPaintedInTheTheme(boolean isDark) throws Exception {
    SwingUtilities.invokeAndWait(() -> {
      Content.setLook(isDark);
      Session session = new Session(recording(), null);
      Theme theme = isDark ? Theme.DARK : Theme.LIGHT;
      session.view().paintIn(theme);
      session.playback().seek(3 * Runs.SECOND_NS);
      session.view().select(Runs.A);
      BufferedImage image = painted(new Content(session, () -> {}));
      assertThat(image.getRGB(30, 400) & 0xFFFFFF).isEqualTo(theme.paper().getRGB() & 0xFFFFFF);
      assertThat(colours(image))
          .contains(theme.paper().getRGB() & 0xFFFFFF, theme.alarm().getRGB() & 0xFFFFFF)
          .hasSizeGreaterThan(60);
    });
  }

  @Test
  void everyCommandHasItsOwnKey() throws Exception {
    SwingUtilities.invokeAndWait(() -> {
      Content.setLook(false);
      Content content = new Content(new Session(recording(), null), () -> {});
      assertThat(content.commands().all())
          .allSatisfy(each -> {
            assertThat(each.keys()).as(each.name()).isNotEmpty();
            assertThat(each.stroke()).as(each.name()).isNotNull();
          });
      assertThat(content.commands().all()).extracting(Command::stroke).doesNotHaveDuplicates();
      assertThat(HelpSheet.html(content.commands())).contains("Next violation", "diamond");
    });
  }

  @Test
  void commandsDoWhatTheirNamesSay() throws Exception {
    SwingUtilities.invokeAndWait(() -> {
      Content.setLook(false);
      Session session = new Session(recording(), null);
      boolean[] isClosed = new boolean[1];
      Content content = new Content(session, () -> isClosed[0] = true);
      run(content, "Next violation");
      assertThat(session.playback().nowNs()).isEqualTo(2 * Runs.SECOND_NS);
      run(content, "Next robot");
      assertThat(session.selected()).isEqualTo(Runs.A);
      run(content, "Play or pause");
      assertThat(session.playback().isPlaying()).isTrue();
      run(content, "The app's zones");
      assertThat(session.view().look().shows("zones")).isFalse();
      run(content, "Dark or light");
      assertThat(session.view().look().theme()).isSameAs(Theme.DARK);
      run(content, "Close");
      assertThat(isClosed[0]).isTrue();
    });
  }

  @Test
  void theBarShowsTheProgressOfChecking() {
    Recording recording = recording();
    assertThat(TransportBar.openText(recording)).isEmpty();
    TraceLoader reading = new TraceLoader(recording, observers -> {}, List::of, List::of);
    assertThat(reading.recording()).isSameAs(recording);
    assertThat(TransportBar.openText(recording)).isEqualTo(" so far, 0% checked");
  }

  private static void run(Content content, String name) {
    content.commands().all().stream()
        .filter(command -> command.name().equals(name))
        .forEach(Command::run);
  }

  @Test
  void everyFaultInTheMenuIsValid() {
    assertThat(Interventions.faults(Runs.A))
        .allSatisfy(item -> assertThat(FaultGrammar.parse(item.fault())).isNotNull());
    String link = Interventions.link(Runs.A, Runs.B).fault();
    assertThat(FaultGrammar.parse(link)).isNotNull();
  }
}
