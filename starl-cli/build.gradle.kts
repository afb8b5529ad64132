plugins {
    `java-library`
    id("maven-publish")
}

description = "The command line, reports, proof export"

dependencies {
    api(project(":starl-core"))
    api(project(":starl-core-input"))
    api(project(":starl-lang"))
    api(project(":starl-primitives"))
    api(project(":starl-primitives-states"))
    api(project(":starl-sim"))
    api(project(":starl-sim-view"))
    api(project(":starl-android-robot"))
    api(project(":starl-apps"))
    api(project(":starl-cli-launch"))
    api(project(":starl-cli-bench"))
    api(libs.jspecify)
    implementation(libs.picocli)
    implementation(libs.jackson.databind)
    implementation(libs.pitest)
    implementation(libs.asm.tree)
    testImplementation(libs.jackson.dataformat.yaml)
    testImplementation(libs.archunit)
    testImplementation(libs.junit.platform.testkit)
    testImplementation(libs.json.schema.validator)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}

// The driver of a browser, which the pages of the viewer are tested with, too.
extensions.configure<JavaPluginExtension> {
    sourceSets.named("test") { java.srcDir("../starl-sim/view/src/browser/java") }
}

tasks.processResources {
    // A new project gets the same Maven wrapper.
    from("../mvnw") {
        into("org/starl/cli/project")
    }
    from("../.mvn/wrapper") {
        into("org/starl/cli/project/.mvn/wrapper")
    }
}

tasks.withType<Jar>().configureEach {
    manifest {
        // The simulator schedules virtual threads itself; java.lang must be open for that.
        attributes(mapOf("Main-Class" to "org.starl.cli.Main", "Add-Opens" to "java.base/java.lang"))
    }
}
