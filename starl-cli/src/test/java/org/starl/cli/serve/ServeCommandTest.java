package org.starl.cli.serve;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.cli.Cli;
import org.starl.cli.command.Apps;
import org.starl.cli.command.ExitStatus;

/** What {@code starl serve} refuses; the module of the server tests what it shows. */
class ServeCommandTest {

  private static Cli serve(String words) {
    return Cli.line(Apps.ALL, "serve --port 0" + (words.isEmpty() ? "" : " " + words));
  }

  @Test
  void badInputIsToldBeforeAnythingElse(@TempDir Path folder) throws Exception {
    serve("intersectoin").assertRefused("intersectoin", "intersection");
    serve("hello --set nope=1").assertRefused("nope");
    serve("hello --fault crash(").assertRefused("--fault", "expected");
    serve("--robots 3").assertRefused("--robots", "a playground");
    serve("--seeds 1..3").assertRefused("--seeds needs an app");
    serve("--processes").assertRefused("--processes needs an app");
    serve("hello --kill bot1@2s").assertRefused("--kill needs --processes");
    serve("hello --processes --seeds 1..3").assertRefused("--seeds", "--processes");
    serve("hello --seeds 3..1").assertRefused("--seeds", "expected");
    serve("hello --seeds 1..3 --seed 4").assertRefused("--seed");
    serve("hello --deployed " + folder).assertRefused("hello", "--deployed");
    serve("--deployed " + folder).assertRefused(folder.toString(), "expected", "*.trace");
    serve("--deployed " + folder.resolve("none")).assertRefused("none");
    Path broken = Files.writeString(folder.resolve("x.trace"), "nothing\n");
    serve(broken.toString()).assertRefused("x.trace", "expected");
    serve("--deployed " + folder).assertRefused("x.trace", "expected");
    Cli.line(Apps.ALL, "serve hello --port 65536").assertRefused("--port", "65536");
    serve("hello --host no.such.host.invalid").assertRefused("--host", "no.such.host.invalid");
    serve("hello --origin app.foxglove.dev").assertRefused("--origin", "expected https://HOST");
  }

  @Test
  void aMissingServerIsTold() {
    Cli cli = serve("hello --seed 7");
    assertThat(cli.status()).isEqualTo(ExitStatus.MISSING_DEPENDENCY);
    assertThat(cli.err()).hasSize(1);
    assertThat(cli.err().getFirst()).contains("./starl serve", "starl-cli-serve");
  }
}
