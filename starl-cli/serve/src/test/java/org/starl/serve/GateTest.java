package org.starl.serve;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.AlphaChars;
import net.jqwik.api.constraints.StringLength;
import org.starl.cli.serve.PageServer.Access;

/** Who may connect. */
class GateTest {

  private static final Gate LOCAL = new Gate(new Access("127.0.0.1", 80, "", List.of()), "lab-pc");
  private static final Gate OPEN =
      new Gate(new Access("0.0.0.0", 80, "5ecre7", List.of("https://app.foxglove.dev")), "lab-pc");

  @Example
  void aBrowserOnThisMachineMayConnect() {
    for (String host : List.of("localhost", "localhost:8080", "127.0.0.1:1", "[::1]:65535")) {
      assertThat(LOCAL.refusal(host, null)).isEmpty();
      assertThat(LOCAL.refusal(host, "http://" + host)).isEmpty();
    }
  }

  @Property
  void aNameThatIsMadeToLeadHereIsRefused(
      @ForAll @AlphaChars @StringLength(min = 1, max = 9) String name) {
    for (String host :
        List.of(name + ".example", name + ".localhost", "localhost." + name, "127.0.0.1." + name)) {
      assertThat(LOCAL.refusal(host, null)).contains("expected an address of this server");
      assertThat(OPEN.refusal(host + ":80", "http://" + host + ":80")).isNotEmpty();
    }
    assertThat(LOCAL.refusal("192.168.1.5", null)).isNotEmpty();
    assertThat(LOCAL.refusal(null, null)).isNotEmpty();
  }

  @Example
  void thisMachinesNameIsItsOwnIfOthersCanConnect() {
    for (String host : List.of("lab-pc:80", "lab-pc", "LAB-PC:80", "lab-pc.local:80")) {
      assertThat(OPEN.refusal(host, "http://" + host)).as(host).isEmpty();
      assertThat(LOCAL.refusal(host, null)).as(host).isNotEmpty();
    }
    assertThat(OPEN.refusal("lab-pc.evil.example", null)).isNotEmpty();
  }

  @Property
  void aPageOfAnotherOriginIsRefused(@ForAll @StringLength(max = 20) String other) {
    for (String origin :
        List.of(other, "http://" + other, "https://localhost", "null", "http://localhost:1")) {
      assertThat(LOCAL.refusal("localhost", origin)).isNotEmpty();
    }
  }

  @Example
  void anOriginThatTheUserNamesMayConnect() {
    assertThat(OPEN.refusal("10.0.0.3:80", "https://app.foxglove.dev")).isEmpty();
    assertThat(OPEN.refusal("10.0.0.3:80", "https://app.foxglove.dev.evil.example")).isNotEmpty();
  }

  @Property
  void onlyTheTokenIsTheToken(@ForAll String given) {
    assertThat(LOCAL.needsToken()).isFalse();
    assertThat(OPEN.needsToken()).isTrue();
    assertThat(OPEN.isToken(given)).isEqualTo(given.equals("5ecre7"));
    assertThat(OPEN.isToken(null)).isFalse();
    assertThat(OPEN.isToken("5ecre7")).isTrue();
  }
}
