package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Bad input: one line with the place, the value and the expected form; exit 2; nothing else. */
class BadInputTest {

  private static final String BAD_ARGUMENTS =
      """
      xyzzy | 'xyzzy' | expected one of list run campaign
      rum | 'rum' | run
      list more | 'more' | did you mean maze?
      run | APP|PRIMITIVE|FILE.yaml | --help
      run nope | 'nope' | expected one of fleet, hello, intersection
      run intersecton | 'intersecton' | did you mean intersection?
      run intersection hello | 'hello' | expected nothing more
      run intersection --robots -3 | --robots | expected a whole number of at least 0
      run hello --robots 0 | robots: 0: expected at least 1
      campaign hello --seeds 1..2 --set robots=0 | robots: 0: expected at least 1
      run intersection --robots 0 | robots: 0 | expected 1 to 12 cars
      run hello --for 10s --fault crash(bot1,at=12s) | 'crash(bot1,at=12s)' | 12s | duration=10s
      run lightpaint --gps-noise 41mm | positionNoise=41mm | at most 40mm for reach tubes
      run lightpaint --delay 5s | an answer takes at least 10s | less than 10s for reach tubes
      run race --set startSpacing=1 | startSpacing=1 | at least 2
      run lightpaint --set startFile=a.wpt | startFile=a.wpt | gives its robots' starts itself
      run hello --robots 90 | robots: 90 | only | 462 mm apart | 5000 by 3000 mm
      run intersection --robots 13 | robots: 13 | expected 1 to 12 cars
      explore agreement --strategy states --loss 0.1 | --loss cannot be used with --strategy states
      explore agreement --strategy states --robots 9 | --robots | '9' | from 1 to 5
      explore race --strategy states | 'race' | expected one of [mutex, agreement, barrier, election, registration, geocast, paths]
      explore mutex --strategy states --set votes=1 | --set votes | expected one of requesters=0..4
      explore barrier --strategy states --set generations=4 | --set generations | '4' | from 1 to 3
      explore election --strategy states --set terms=2 | --set terms: no such bound | timers=0..5
      explore registration --strategy states --set leaves=2 | --set leaves | '2' | from 0 to 1
      explore mutex --states 4 | --states | expected --strategy states
      run intersection --robots many | 'many' | expected a whole number
      run intersection --robots 2147483648 | '2147483648' | from 0 to 2147483647
      run hello --robots 99999999999999999999999 | expected a whole number from 0 to 2147483647
      run intersection --loss 7 | --loss | '7' | expected a probability from 0 to 1
      run intersection --loss NaN | --loss | expected a probability from 0 to 1
      run intersection --delay banana(1) | --delay | 'banana(1)' | expected a delay
      run intersection --delay uniform(20ms,10ms) | --delay | expected
      run intersection --delay 100 | --delay | '100' | expected
      run intersection --gps-noise -1mm | --gps-noise | expected a distance
      run intersection --gps-noise 5miles | --gps-noise | expected a distance
      run intersection --for 5 | --for | '5' | expected a duration with a unit
      run intersection --for 99999999999h | --for | expected a duration below 70 years
      run intersection --seed seven | --seed | 'seven' | expected a whole number
      run intersection --seed 1.5 | --seed | '1.5' | expected a whole number
      run intersection --seed 9223372036854775808 | --seed | to 9223372036854775807
      run intersection --seed | --seed
      run intersection --seed 1 --seed 2 | --seed=S: expected it once
      run intersection --sed 3 | --sed | did you mean | --seed
      run intersection --specs none | --specs | expected one of off, safety, all | 'none'
      run mutex --processes --specs off | --specs cannot be used with --processes
      run intersection --carrier horse | --carrier | expected one of | 'horse'
      run intersection --set debris | --set | KEY=VALUE
      run hello --set robots=2 --set robots=3 | --set robots: expected it once
      run hello --set robots=2 --robots 3 | --set robots: --robots gives it, too; expected one of them
      campaign hello --seeds 1..2 --set messageLoss=0 --loss 0 | --set messageLoss: --loss gives it, too
      explore agreement --strategy states --set votes=1 --set votes=2 | --set votes: expected it once
      run intersection --set debris=9 | debris | '9' | from 0 to 8
      run intersection --set debris=much | debris | 'much' | from 0 to 8
      run intersection --set debrs=1 | 'debrs' | did you mean debris?
      run intersection --set messageLos=1 | 'messageLos' | did you mean messageLoss?
      run intersection --set zzzzzzzzzz=1 | 'zzzzzzzzzz' | expected one of
      bench b9 | 'b9' | expected b1, b2, b3a, b3b, b3c, b4b, b4a, b5, fleet, mutex, view or apps
      run mutex --processes --set radioRange=3m | radioRange | --processes | expected --loss or --delay
      run mutex --set radioSight=true | radioSight | expected a radioRange
      bench b3a --style blocking | b3a | blocking | expected step
      bench b4b --robots 3 | b4b | 3 robots | expected a multiple of 4
      bench apps | expected --inputs FOLDER
      bench apps --inputs . --app race --input nope | --input | 'nope' | four.wpt
      bench apps --inputs /no/such | --inputs | /no/such | expected a folder
      run intersection --set scenario=figure8 | 'figure8' | expected drawn, figure7, legacy or open
      run intersection --set arrivals=20 | arrivals: '20' | expected a rate | 20/min
      run intersection --set arrivals=0/min | arrivals: '0/min' | expected a rate above 0
      run intersection --set arrivals=20/ms | arrivals: '20/ms' | expected a rate
      run intersection --set arrivals=20/min --robots 0 | robots: 0 | at least 1 on an open road
      run intersection --set arrivals=20/min --for 0 | duration | where cars arrive until then
      run intersection --set arrivals=9/min --set scenario=figure7 | expected scenario=open
      run intersection --set scenario=legacy | files | expected the folder
      run intersection --set scenario=legacy --set files=/nowhere | no such file
      run intersection --set scenario=figure7 --robots 3 | robots: 3 | expected 4
      run intersection --set obstacleFile=nowhere.wpt | nowhere.wpt: no such file
      run intersection --set robotRadius=300mm | robotRadius=300mm | below 250mm | lane
      run intersection --set obstacleFile=/dev/zero | /dev/zero: is not a regular file
      run maze --set map=/dev/zero | /dev/zero: is not a regular file
      run hello --set positionPeriod=1ns | positionPeriod=1ns | at least 1ms
      run hello --fault forge(all,1ns) | 'forge(all,1ns)' | the mean interval | at least 100us
      run race --csv /dev/full --png /dev/null | --csv: '/dev/full': cannot be written (No space left on device)
      run race --csv-messages /dev/full --png /dev/null | --csv-messages: '/dev/full': cannot be written
      run hello --trace /dev/null/b | --trace: '/dev/null/b': cannot be written ('/dev/null' is a file already); expected the name of a file
      run hello --png /dev/full | --png: '/dev/full': cannot be written (No space left on device)
      run hello --trace /dev/full --png /dev/null | --trace: '/dev/full': cannot be written | No space left
      record hello --png --out /dev/full | --out: '/dev/full': cannot be written | No space left
      record hello --gif --out /dev/full | --out: '/dev/full': cannot be written | No space left
      record hello --mcap --out /dev/full | --out: '/dev/full': cannot be written | No space left
      record hello --csv positions --out /dev/full | --out: '/dev/full': cannot be written | No space left
      record hello --out x.mcap | --out: 'x.mcap': expected a name that ends with .png
      record hello --out x.PNG.gif | --out: 'x.PNG.gif': expected a name that ends with .png
      record hello --mcap --out x.png | --out: 'x.png': expected a name that ends with .mcap
      record hello --gif --out x.html | --out: 'x.html': expected a name that ends with .gif
      record hello --csv --out x.mcap | --out: 'x.mcap': expected a name that ends with .csv
      record hello --html x.png | --html: 'x.png': expected a name that ends with .html
      run hello --png x.gif | --png: 'x.gif': expected a name that ends with .png
      run hello --trace x.html | --trace: 'x.html': expected a name that ends with .trace
      run hello --csv x.png | --csv: 'x.png': expected a name that ends with .csv
      campaign hello --seeds 1..2 --report x.csv | --report: 'x.csv': expected a name that ends with .html
      explore mutex --seed 1 --chart x.png | --chart: 'x.png': expected a name that ends with .svg
      run intersection --set arrivals=601/min | arrivals: '601/min' | at most 600/min
      run hello --fault datagram(bot0,1,lost) | 'bot0' | expected a sender and a recipient
      run hello --fault datagram(bot0>bot1,-1,lost) | the number of a datagram | '-1'
      run hello --fault datagram(bot0>bot1,1,soon) | a duration, or 'lost' | 'soon'
      run hello --fault datagram(bot0>bot9,1,lost) | no robot is called bot9
      run hello --fault crush(bot1) | --fault | 'crush' | did you mean crash?
      run hello --fault crash | --fault | expected a robot's name | as in crash(WHO
      run hello --fault crash(bot1,at=5) | --fault | at: '5' | expected a duration with a unit
      run hello --fault crash(bot1,when=5s) | --fault | no argument is called 'when'
      run hello --fault loss(2) | --fault | '2' | expected a probability from 0 to 1
      run hello --fault loss(0.1,for=5s,until=9s) | --fault | not by both
      run hello --fault delay(soon) | --fault | 'soon' | expected a delay
      run hello --fault partition(area=circle(1)) | --fault | area: 'circle(1)' | expected rect
      run hello --fault stuck(bot9) | 'stuck(bot9)' | no robot is called bot9 | bot3
      run hello --fault stuck(bot9,at=1s) | 'stuck(bot9,at=1s)' | no robot is called bot9
      campaign hello --seeds 1..2 --fault stuck(bot9,at=1s) | no robot is called bot9
      campaign hello --seeds 1..2 --fault range(far) | --fault | 'far' | expected a distance
      record hello --fault | --fault
      verify-determinism hello --fault sight(1) | --fault | an extra argument
      run hello --set faults=crash(bot1,at=never) | faults='crash(bot1,at=never)' | a duration
      run hello --set chaos=logica | chaos='logica' | did you mean logical?
      run nowhere.yaml | nowhere.yaml: no such file | expected a scenario file
      campaign intersection | --seeds=A..B
      campaign intersection --seeds 5..1 | '5..1' | expected A..B
      campaign intersection --seeds a..b | 'a..b' | expected A..B
      campaign intersection --seeds -1..4 | '-1..4' | expected A..B
      campaign intersection --seeds 0..2147483648 | expected A..B
      campaign intersection --seeds 0..2147483647 | at most 10000000 seeds
      campaign intersection --seeds 1..4 --threads 0 | --threads | from 1 to 1024
      campaign intersection --seeds 1..4 --robots 13 | robots: 13 | expected 1 to 12 cars
      record intersection --png noon | --png | 'noon' | expected t=TIME
      record intersection --gif --mcap | --gif | --mcap
      record intersection --png end --when best | --when | expected only one of the two
      record intersection --gif --when end | --when | expected --when violation
      record intersection --gif --every 1us | --every | at least 1ms
      record intersection --gif --html | --gif | --html
      record intersection --html a.html --out b.html | --out | expected one of the two
      record intersection --html --when end | --when | expected no --when
      record intersection --html a.html --every 1us | --every | at least 1ms
      record intersection --gif --width 1 | --width | from 100 to 4000
      record intersection --png t=12 | --png | '12' | expected a duration with a unit
      verify-determinism nope | 'nope' | expected one of
      bench | WORKLOAD
      simulated-create | starl: expected --pty=NAME or --tcp=[HOST:]PORT; | see 'starl simulated-create --help'
      deploy check | see 'starl deploy check --help'
      run hello --set robots | --set: 'robots': expected KEY=VALUE
      run hello --json=3 | starl: --json: '3': expected no value;
      completion csh | starl: SHELL: 'csh': expected one of BASH, ZSH, FISH;
      run hello --trace | starl: expected --trace=FILE;
      help nope | 'nope': expected a command | see 'starl --help'
      bench b1 --robots none | --robots | 'none' | expected a whole number
      bench fleet --robots 1 | --robots | '1' | expected a whole number from 2 to 256
      bench b1 --robots 0 | --robots | '0' | expected a whole number
      bench b1 --runs 0 | --runs | '0' | expected a whole number
      bench b1 --style lazy | --style | expected one of | 'lazy'
      """;

  private static final String BAD_FILES =
      """
      app: intersection\\nrobots: many | :2: | robots='many' | expected a whole number
      app: intersection\\nrobots:\\n  most: 4 | :2: robots: | expected one value
      app: intersection\\nrobots: [1, 2] | :2: robots: | expected one value
      app: intersection\\nrobots: | robots: | expected one value
      app: intersection\\nrobots: [1] | :2: robots: a list of 1: expected one value, such as 'robots: 4'
      app: [hello] | :1: app: a list of 1: expected one value, such as 'app: intersection'
      app: hello\\nfaults: [~] | :2: faults: '': expected a list of faults
      app: hello\\nfaults: {crash: bot1} | :2: faults: a mapping: expected a list of faults
      app: intersection\\nrobots: !!int + | :2: robots: | expected one value
      app: hello\\nfaults: [!!int +] | :2: faults: | expected one value
      app: intersection\\n# eight\\nrobots: 8\\nrobots: 9 | :4: | robots | once
      robots: 4 | has no 'app:' | lines such as
      app: intersection\\ndebrs: 2 | :2: | 'debrs' | did you mean debris?
      app: crossroads | :1: | 'crossroads' | expected one of
      - app\\n- intersection | :1: | lines such as
      intersection | :1: | lines such as
      app: intersection\\n---\\napp: hello | expected one document
      app: "intersection | is not YAML | lines such as
      app: hello\\nfaults: [loss(0.1), crush(bot1)] | :2: faults='crush(bot1)' | did you mean crash?
      app: hello\\nfaults: [[loss(0.1)]] | :2: faults: | expected a list of faults
      app: hello\\nfaults: [sight]\\nfaults: [sight] | :3: faults: | once
      app: hello\\nchaos: maybe | :2: chaos='maybe' | expected one of none, network
      app: intersection\\nrobots: 13 | robots: 13 | expected 1 to 12 cars
      """;

  @TempDir private Path folder;

  private static void assertRefused(Cli cli, String... saying) {
    assertThat(cli.err()).as("%s", cli).hasSize(1);
    assertThat(cli.err().get(0)).startsWith("starl: ").contains(saying);
    assertThat(cli.out()).isEmpty();
    assertThat(cli.status()).isEqualTo(2);
  }

  static Stream<String> badArguments() {
    return BAD_ARGUMENTS.lines();
  }

  @ParameterizedTest
  @MethodSource("badArguments")
  void badArgumentsAreRefusedInOneLine(String line) {
    String[] parts = line.split(" [|] ");
    assertRefused(Cli.run(parts[0].split(" ")), Arrays.copyOfRange(parts, 1, parts.length));
  }

  @Test
  void noCommandIsRefused() {
    assertRefused(
        Cli.run(), "no command", "starl run hello", "starl list", "starl new", "starl --help");
  }

  static Stream<String> badFiles() {
    return BAD_FILES.lines();
  }

  @ParameterizedTest
  @MethodSource("badFiles")
  void aBrokenScenarioFileIsRefused(String line) throws IOException {
    String[] parts = line.split(" [|] ");
    String[] saying = Arrays.copyOfRange(parts, 1, parts.length);
    Path file = folder.resolve("my.yaml");
    Files.writeString(file, parts[0].replace("\\n", "\n"));
    assertRefused(Cli.run("run", file.toString()), saying);
    assertRefused(Cli.run("campaign", file.toString(), "--seeds", "1..3"), saying);
  }

  @Test
  void aFileThatIsNotTextIsRefused() throws IOException {
    Path binary = folder.resolve("picture.yaml");
    Files.write(binary, new byte[] {(byte) 0x89, 'P', 'N', 'G', 0, 1, 2, (byte) 0xFF});
    assertRefused(Cli.run("run", binary.toString()), "picture.yaml", "is not text", "expected");
    Path zeros = folder.resolve("zeros.yaml");
    Files.write(zeros, new byte[100]);
    assertRefused(Cli.run("run", zeros.toString()), "zeros.yaml", "is not text", "expected");
    Files.write(zeros, new byte[0]);
    assertRefused(Cli.run("run", zeros.toString()), "zeros.yaml", "lines such as");
    Path inner = Files.createDirectory(folder.resolve("folder.yaml"));
    assertRefused(Cli.run("run", inner.toString()), "folder.yaml", "is a folder", "expected");
  }

  @Test
  void aBrokenLineOfAWaypointFileIsRefused() throws IOException {
    Files.writeString(folder.resolve("start.wpt"), "WAY,2250,3500,270,bot0\n");
    Files.writeString(folder.resolve("obstacles.wpt"), "");
    Files.writeString(
        folder.resolve("dest.wpt"), "WAY,1,2,0,a\nWAY,12,x\n", StandardCharsets.UTF_8);
    assertRefused(
        Cli.run("run", "intersection", "--set", "scenario=legacy", "--set", "files=" + folder),
        "dest.wpt:2: 'WAY,12,x': expected WAY,x,y,angle,name[,radius]");
  }

  @Test
  void aRefusedRunLeavesNoFiles() throws IOException {
    String trace = folder.resolve("a.trace").toString();
    String csv = folder.resolve("a.csv").toString();
    String png = folder.resolve("a.png").toString();
    Path inTheWay = Files.createDirectory(folder.resolve("inTheWay"));
    assertRefused(
        Cli.run("run", "hello", "--trace", trace, "--csv", csv, "--png", inTheWay.toString()),
        "--png",
        "expected a file's name");
    assertRefused(
        Cli.run("run", "hello", "--trace", trace, "--csv", trace, "--png", png),
        "--csv",
        "expected a file of its own");
    String bad = "obstacleFile=nowhere";
    assertRefused(
        Cli.run("run", "hello", "--trace", trace, "--csv", csv, "--png", png, "--set", bad),
        "nowhere: no such file");
    assertRefused(
        Cli.run("record", "hello", "--png", "end", "--out", inTheWay.toString()),
        "--out",
        "expected a file's name");
    try (Stream<Path> left = Files.list(folder)) {
      assertThat(left).containsExactly(inTheWay);
    }
  }

  @Test
  void aFileThatCannotBeWrittenIsRefusedBeforeTheRun() throws IOException {
    Path file = Files.writeString(folder.resolve("file"), "text");
    String below = file.resolve("a.trace").toString();
    assertRefused(Cli.run("run", "hello", "--trace", below), "--trace", "cannot be written");
    assertRefused(Cli.run("run", "hello", "--png", below), "--png", "cannot be written");
    assertThat(file).hasContent("text");
  }

  @Test
  void stacktraceShowsWhere() {
    Cli cli = Cli.run("run", "intersection", "--robots", "13", "--stacktrace");
    assertThat(cli.status()).isEqualTo(2);
    assertThat(cli.err()).anyMatch(line -> line.contains("at org.starl.apps.intersection."));
    assertThat(cli.err().get(cli.err().size() - 1)).contains("robots: 13: expected");
  }
}
