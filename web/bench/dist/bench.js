var Ja="";function bf(i){Ja=i.trim()}function Mf(){return Ja!==""}var on=class extends Error{constructor(t,e,n=[]){super(e),this.status=t,this.reasons=n}};function zh(i={}){return Ja?{...i,Authorization:`Bearer ${Ja}`}:i}async function wf(i){if(i.ok)return i;let t={};try{t=await i.json()}catch{}throw new on(i.status,t.error??`${i.status} ${i.statusText}`,t.reasons??[])}async function Wo(i,{signal:t,more:e}={}){return wf(await fetch(i,{headers:zh(e),signal:t,cache:"no-store",credentials:"omit"}))}async function Li(i,t){return(await Wo(i,t)).json()}async function rr(i,t){return(await Wo(i,t)).arrayBuffer()}async function Ka(i,t){let e=await Wo(i,t),n=Number(e.headers.get("lfpiv-white"));return{bitmap:await createImageBitmap(await e.blob()),white:n}}async function Tf(i,t){let e={method:"POST",headers:zh(),credentials:"omit"};return t!==void 0&&(e.headers=zh({"Content-Type":"application/json"}),e.body=JSON.stringify(t)),(await wf(await fetch(`/api/v1/control/${i}`,e))).json()}function q(i,t={},...e){let n=document.createElement(i);for(let[s,r]of Object.entries(t))r===!1||r===null||r===void 0||(s.startsWith("on")?n.addEventListener(s.slice(2),r):n.setAttribute(s,r===!0?"":String(r)));return n.append(...e.flat().filter(s=>s!=null)),n}function $t(i,t){let e=String(t);i.textContent!==e&&(i.textContent=e)}function An(i,t,e){e===null?i.removeAttribute(t):i.getAttribute(t)!==String(e)&&i.setAttribute(t,e)}function Gt(i,{wide:t=!1,title:e}={}){let n=q("dd",{class:"value"},"–");return{element:q("div",{class:t?"reading wide":"reading",title:e},q("dt",{},i),n),show(r,o=null){$t(n,r),An(n,"data-tone",o)}}}function cs(i){return{tabindex:"0",role:"region","aria-label":i}}function Be(i,...t){return q("section",{class:"panel"},q("h2",{},i),...t)}var Vh=0;function ii(i,t,e){let n=`choice-${Vh+=1}`,s=q("select",{id:n,onchange:()=>e(s.value)},...Object.entries(t).map(([r,o])=>q("option",{value:r},o)));return{element:q("div",{class:"choice"},q("label",{for:n},i),s),input:s}}function or(i,{max:t,value:e=0,step:n=1},s){let r=`slider-${Vh+=1}`,o=q("output",{for:r}),a=q("input",{id:r,type:"range",min:0,max:t,step:n,value:e,oninput:()=>s(Number(a.value))});return{element:q("div",{class:"choice"},q("label",{for:r},i),a,o),input:a,shown:o}}function Fs(i,t,e){let n=`tick-${Vh+=1}`,s=q("input",{id:n,type:"checkbox",checked:t,onchange:()=>e(s.checked)});return{element:q("div",{class:"choice tick"},s,q("label",{for:n},i)),input:s}}function Os(i){let t=Math.min(window.devicePixelRatio||1,2),e=Math.max(1,Math.round(i.clientWidth*t)),n=Math.max(1,Math.round(i.clientHeight*t));return(i.width!==e||i.height!==n)&&(i.width=e,i.height=n),{width:e,height:n,ratio:t}}function Bn(i){return getComputedStyle(document.documentElement).getPropertyValue(`--${i}`).trim()}var f_=15e3,ja=class{constructor(t){this.run=t,this.said=q("p",{class:"said",role:"status"}),this.input=q("input",{type:"password",id:"token",autocomplete:"off",spellcheck:"false",size:40}),this.why=q("p",{}),this.dialog=q("dialog",{"aria-labelledby":"token-title"},q("form",{onsubmit:e=>this.take(e)},q("h2",{id:"token-title"},"Token"),this.why,q("label",{for:"token"},"Token of scope read or control"),this.input,q("p",{class:"hint"},"It is kept in this page's memory until the page is closed, and nowhere else."),q("div",{class:"row"},q("button",{type:"submit",class:"primary"},"Use it"),q("button",{type:"button",onclick:()=>this.dialog.close()},"Cancel"))))}askForToken(t=""){$t(this.why,t),this.dialog.open||this.dialog.showModal(),this.input.focus()}take(t){t.preventDefault(),bf(this.input.value),this.input.value="",this.dialog.close(),this.run.reconnect(),this.say(Mf()?"The token is used from now on.":"No token is used.")}say(t,e=null){$t(this.said,t),e?this.said.setAttribute("data-tone",e):this.said.removeAttribute("data-tone"),clearTimeout(this.fading),t&&!e&&(this.fading=setTimeout(()=>this.say(""),f_))}doubt(){this.said.hasAttribute("data-tone")||this.say("")}async send(t,e){this.say(`${t} …`);try{let n=await Tf(t,e);return this.say(n.pending?`${t}: the bench is still about it.`:`${t}: done, the run is ${n.mode}.`),!0}catch(n){let s=n instanceof on?n.message:"the daemon does not answer: use the interlock";return this.say(`${t} failed: ${s}`,"bad"),n instanceof on&&n.status===401&&this.askForToken(`${t} needs a token of scope control.`),!1}finally{this.run.ask()}}};var Gh=class{constructor({event:t,comment:e}){this.event=t,this.comment=e,this.rest="",this.clear()}clear(){this.name="message",this.id=null,this.data=[]}push(t){let e=(this.rest+t).split(`
`);this.rest=e.pop(),e.forEach(n=>this.line(n.replace(/\r$/,"")))}line(t){if(t===""){this.data.length>0&&this.event(this.name,this.data.join(`
`),this.id),this.clear();return}if(t.startsWith(":")){this.comment(t.slice(1).trim());return}let e=t.indexOf(":"),n=e<0?t:t.slice(0,e),s=e<0?"":t.slice(e+1).replace(/^ /,"");n==="event"?this.name=s:n==="id"?this.id=s:n==="data"&&this.data.push(s)}};async function Ef(i,t,e){let s=await Wo("/api/v1/events",{signal:e,more:i?{Accept:"text/event-stream","Last-Event-ID":i}:{Accept:"text/event-stream"}}),r=new Gh(t),o=new TextDecoder,a=s.body.getReader();for(;;){let{done:c,value:l}=await a.read();if(c)return;r.push(o.decode(l,{stream:!0}))}}var p_="LFPIVMK1";async function Af(){return m_(await rr("/api/v1/mask"))}function m_(i){let t=new DataView(i),e=String.fromCharCode(...new Uint8Array(i,0,8));if(e!==p_)throw new Error(`a mask of another version: ${e}`);let n=[16,20,24].map(o=>t.getUint32(o,!0)),s=new Uint8Array(i,t.getUint32(28,!0)),r=new Uint8Array(n[0]*n[1]*n[2]);for(let o=0;o<r.length;o+=1)r[o]=s[o>>3]>>(o&7)&1;return{n,first:[32,40,48].map(o=>t.getFloat64(o,!0)),voxel:t.getFloat64(56,!0),flow:r}}function Rf(i,t,e){let{n,flow:s}=i,r=[1,n[0],n[0]*n[1]],o=3-t-e,a=new Float32Array(n[t]*n[e]);for(let c=0;c<n[e];c+=1)for(let l=0;l<n[t];l+=1){let h=c*r[e]+l*r[t],d=0;for(let u=0;u<n[o];u+=1,h+=r[o])d+=1-s[h];a[c*n[t]+l]=d/n[o]}return a}function Cf(i,t,e){let{n,first:s,voxel:r,flow:o}=i,a=[1,n[0],n[0]*n[1]],c=[],l=t.map((d,u)=>Math.max(0,Math.ceil((d-s[u])/r-1e-6))),h=e.map((d,u)=>Math.min(n[u]-1,Math.floor((d-s[u])/r+1e-6)));for(let d=l[2];d<=h[2];d+=1)for(let u=l[1];u<=h[1];u+=1)for(let f=l[0];f<=h[0];f+=1){let p=[f,u,d],y=f+u*a[1]+d*a[2];for(let m=0;m<3;m+=1)p[m]<h[m]&&o[y]!==o[y+a[m]]&&c.push(...g_(i,p,m))}return new Float32Array(c)}function g_({first:i,voxel:t},e,n){let[s,r]=[(n+1)%3,(n+2)%3],o=(c,l)=>{let h=e.map((d,u)=>i[u]+d*t);return h[n]+=t/2,h[s]+=(c-.5)*t,h[r]+=(l-.5)*t,h},a=[o(0,0),o(1,0),o(1,1),o(0,1)];return[0,1,2,0,2,3].flatMap(c=>a[c])}var __=[[1e12,"T"],[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""]];function Ht(i,t=3){if(i==null||!Number.isFinite(i))return"–";if(i===0)return"0";let e=Math.max(0,Math.min(6,t-1-Math.floor(Math.log10(Math.abs(i)))));return i.toFixed(e).replace("-","−")}function Rn(i){return i===null?"":String(Number(i.toPrecision(6))).replace("-","−")}function le(i){return i==null?"–":i.toLocaleString("en-GB").replaceAll(","," ")}function Cn(i,t=0){return i==null||!Number.isFinite(i)?"–":`${(100*i).toFixed(t)} %`}function Pf(i){if(i==null)return"–";let[t,e]=__.find(([n])=>i>=n)??[1,""];return`${Ht(i/t)} ${e}B`}function hs(i){return i==null||!Number.isFinite(i)?"–":i<10?`${Ht(i,2)} s`:i<120?`${Math.round(i)} s`:i<7200?`${Math.round(i/60)} min`:`${Ht(i/3600)} h`}function If(i){let t=i?new Date(i):null;return t&&!Number.isNaN(t.getTime())?t.toLocaleTimeString("en-GB"):"–"}var x_={starting:"starting",running:"running",bench_lost:"synchroniser lost",stopping:"stopping",finished:"finished",failed:"failed"},Lf=i=>x_[i]??i??"–",v_={awaiting_frames:"waits for frames",queued:"queued",processing:"is measured",done:"done",failed:"failed",write_failed:"not written",shed:"shed",not_fired:"not fired",lost:"lost"},Xo=i=>v_[i]??i??"–",y_={complete:"complete",missing_packets:"packets missing",underrun:"no buffer",missed_trigger:"missed trigger",late:"late",unpaired:"unpaired",shed:"shed",write_failed:"not written",not_fired:"not fired"},Hh=i=>y_[i]??i??"open",S_={start:"start",stop:"stop",arm:"arm",disarm:"disarm",go_on:"go on",set_dt:"dt",note:"note"};function Df(i){let t=S_[i.command]??String(i.command);return i.refused?{tone:"bad",text:`${t} was refused: ${i.refused.join("; ")}`}:i.command==="note"?{tone:"note",text:`Note: ${i.text}`}:i.command==="set_dt"?{tone:null,text:`dt is ${Ht(i.dt_us)} µs from the next burst on`}:{tone:null,text:`${t}: the run is ${i.mode}`}}function Nf(i){let t=`Shot ${i.shot}`;return i.stage==="failed"?{tone:"bad",text:`${t} gave no result: ${i.message??"no reason given"}`}:i.stage==="write_failed"?{tone:"bad",text:`${t} was not written: ${i.message??""}`}:i.fit&&i.fit.verdict!=="good"?{tone:i.fit.verdict==="poor"?"bad":"doubt",text:`${t}: model fit ${i.fit.verdict}. ${i.fit.causes[0]??""}`}:i.warnings?.length?{tone:"doubt",text:`${t}: ${i.warnings[0]}`}:null}var b_=2e3,Wh=200,M_=200,w_=400,T_=900,E_=2e3,A_=200,Uf=[300,600,1200,2500],Qa=class{constructor(){this.listeners=new Set,this.resultListeners=new Set,this.forget(),this.connection="connecting",this.refusal=null,this.lastSign=-1/0,this.aborter=null,this.attempt=0,this.toldStale=null,this.telling=null}forget(){this.run=null,this.lastId=null,this.historyUpTo=0,this.status=null,this.brief=null,this.control=null,this.shots=new Map,this.log=[],this.latestResult=null,this.finished=[],this.frames=[],this.backlog=[],this.mask=null}get stale(){return performance.now()-this.lastSign>b_}watch(t){this.listeners.add(t)}watchResults(t){this.resultListeners.add(t)}tell(){this.telling??=setTimeout(()=>{this.telling=null,this.toldStale=this.stale,this.listeners.forEach(t=>t())},A_)}start(){this.connect(),setInterval(()=>this.ask(),E_),setInterval(()=>{this.stale!==this.toldStale&&this.tell()},250)}reconnect(){this.attempt=0,this.aborter?.abort(),this.waiting&&(clearTimeout(this.waiting),this.connect())}async connect(){this.waiting=null,this.aborter=new AbortController;let t={event:(n,s,r)=>this.event(n,s,r),comment:n=>n==="heartbeat"&&this.sign()};try{this.ask(),await Ef(this.lastId,t,this.aborter.signal),this.connection="lost"}catch(n){this.refusal=n instanceof on?n:null,this.connection=this.refusal?"refused":"lost"}this.tell();let e=this.aborter.signal.aborted?0:Uf[Math.min(this.attempt,Uf.length-1)];this.attempt+=1,this.waiting=setTimeout(()=>this.connect(),e)}sign(){this.lastSign=performance.now(),this.attempt=0,this.refusal=null,this.connection="live",this.toldStale&&this.tell()}event(t,e,n){let s=JSON.parse(e),r=n?this.place(n):null,o=r!==null&&r<=this.historyUpTo;t==="status"&&!o?(this.brief=s,this.control=s.control,this.noteFrames(s.cameras),this.sign()):t==="control"?(!o&&s.mode&&(this.control={mode:s.mode,dt_us:s.dt_us,held:s.held}),this.note(Df(s),o),o||this.ask()):t==="shot"?this.shotEnded(s,o):t==="result"&&!o?(this.latestResult=s.shot,this.resultListeners.forEach(a=>a(s.shot))):t==="watermarks"&&this.brief?this.brief.watermarks=s:t==="missed"&&s.missed&&this.note({tone:"doubt",text:`${s.missed} events were missed`},o),this.tell()}place(t){let[e,n]=t.split("-"),s=Number(n);if(e!==this.run){let r=this.run!==null;this.forget(),r&&(this.note({tone:null,text:"The daemon was started again: this is another run"},!1),this.resultListeners.forEach(o=>o(null))),this.run=e,this.historyUpTo=s,this.lastId=`${e}-${Math.max(0,s-w_)}`,s>0&&queueMicrotask(()=>this.aborter?.abort()),this.ask()}else this.lastId=t;return s}noteFrames(t){let e=performance.now();this.frames=(t??[]).map(({camera:n,connected:s,frames:r},o)=>{let a=this.frames[o],c=a&&a.frames===r?a.since:e;return{camera:n,connected:s,frames:r,since:c}})}noteBacklog(t){t&&(this.backlog.push({at:performance.now(),backlog:t.shots.backlog,inHand:t.shots.in_hand}),this.backlog.length>T_&&this.backlog.shift())}shotEnded(t,e){let{shot:n}=t,s=this.shots.get(n)??{shot:n,cameras:[]};this.keepShot({...s,...t,state:t.stage,model_fit:t.fit}),e||(this.finished.push({at:performance.now(),shot:n}),this.finished.length>Wh&&this.finished.shift());let r=Nf(t);r&&this.note(r,e)}keepShot(t){for(this.shots.set(t.shot,t);this.shots.size>Wh;)this.shots.delete(Math.min(...this.shots.keys()))}note(t,e){this.log.push({...t,at:e?null:new Date}),this.log.length>M_&&this.log.shift()}async ask(){if(this.asking||document.hidden)return;this.asking=!0;let{signal:t}=this.aborter??new AbortController;try{let[e,n,s]=await Promise.all([Li("/api/v1/status",{signal:t}),Li("/api/v1/control",{signal:t}),Li("/api/v1/shots?limit=60",{signal:t})]);if(this.status=e,this.noteBacklog(e.cluster),this.permissions=n,this.control=n.state,this.brief||this.noteFrames(e.cameras),s.shots.reverse().forEach(r=>this.keepShot(r)),this.latestResult===null){let o=[...this.shots.values()].filter(a=>a.vectors).map(a=>a.shot).sort((a,c)=>c-a)[0];o!==void 0&&(this.latestResult=o,this.resultListeners.forEach(a=>a(o)))}e.configuration.mask&&!this.mask&&(this.mask=await Af()),this.refusal=null}catch(e){e instanceof on&&(this.refusal=e)}finally{this.asking=!1,this.tell()}}latestShots(t){return[...this.shots.values()].sort((e,n)=>n.shot-e.shot).slice(0,t)}get lastEnded(){return this.latestShots(Wh).find(t=>["done","failed","write_failed","lost"].includes(t.state))}get rate(){let t=performance.now(),e=this.finished.filter(({at:n})=>t-n<1e4);return e.length<2?0:e.length/Math.max(1,(t-e[0].at)/1e3)}};var R_=3e3;function tl(i){if(i.stale)return{word:"unknown",detail:"no sign of life: use the interlock",tone:"unknown"};let t=i.brief?.state??i.status?.state;if(i.permissions&&!i.permissions.controllable)return{word:"no laser",detail:"a recorded run is shown",tone:"safe"};if(t==="failed")return{word:"unknown",detail:"the run has failed: use the interlock",tone:"unknown"};if(t==="finished")return{word:"safe",detail:"the run is over",tone:"safe"};let e=i.control;if(!e||t==="starting")return{word:"safe",detail:t==="starting"?"disabled while the run starts":"nothing is fired",tone:"safe"};switch(e.mode){case"disarmed":return{word:"safe",detail:"disarmed: lamps and Q-switches off",tone:"safe"};case"armed":return{word:"armed",detail:"the lamps fire, the Q-switches do not",tone:"armed"};case"firing":return e.held?.length?{word:"held",detail:e.held.join("; "),tone:"armed"}:{word:"firing",detail:"light pulses: goggles on",tone:"firing"};case"lost":return{word:"unknown",detail:"the synchroniser does not answer: use the interlock",tone:"unknown"};case"stopping":return{word:"stopping",detail:"the laser is made safe",tone:"armed"};default:return{word:"unknown",detail:`mode ${e.mode}`,tone:"unknown"}}}function Ff(i){return(i.status?.configuration.cameras??i.frames.map(e=>e.camera)).map((e,n)=>{let s=i.frames[n];if(i.stale||!s)return{name:e,word:"unknown",tone:"unknown"};if(i.permissions&&!i.permissions.controllable)return{name:e,word:"recorded",tone:"safe"};if(!s.connected)return{name:e,word:"gone",tone:"bad"};let r=i.control?.mode==="firing"&&!i.control.held?.length,o=performance.now()-s.since;return r&&o>R_?{name:e,word:"silent",tone:"doubt"}:{name:e,word:r?"delivers":"alive",tone:"good"}})}function Of(i){let t=i.lastEnded;if(!t)return{word:"none yet",detail:"",tone:null};let e=`shot ${t.shot}`;if(t.state!=="done")return{word:Xo(t.state),detail:e,tone:i.stale?"unknown":"bad"};let n=t.model_fit?.verdict,s=`${e}, ${Cn(t.valid_share)} valid`;return i.stale?{word:n??"measured",detail:s,tone:"unknown"}:{word:n??"measured",detail:s,tone:{good:"good",doubtful:"doubt",poor:"bad"}[n]??null}}function Xh(i,t=""){let e=q("strong",{}),n=q("span",{class:"detail"}),s=q("div",{class:`lamp ${t}`},q("span",{class:"label"},i),e,n);return{element:s,show({word:r,detail:o="",tone:a}){$t(e,r),$t(n,o),An(s,"data-tone",a??null),An(s,"title",o||null)}}}function Bf(i,t){let e=Xh("Laser","laser"),n=q("div",{class:"cameras"}),s=Xh("Last shot","shot"),r=q("span",{class:"live",role:"status"}),o=q("button",{type:"button",class:"stop",onclick:()=>t.send("stop")},"Stop"),a=q("button",{type:"button",class:"disarm",onclick:()=>t.send("disarm")},"Disarm"),c=q("button",{type:"button",class:"quiet",onclick:()=>t.askForToken()},"Token"),l=q("div",{class:"safety"},q("div",{class:"press"},o,a),e.element,n,s.element,q("div",{class:"connection"},r,c)),h=[];function d(){e.show(tl(i));let u=Ff(i);for(;h.length<u.length;)h.push(Xh("","camera")),n.append(h.at(-1).element);h.forEach((p,y)=>{let m=u[y];p.element.hidden=!m,m&&($t(p.element.firstChild,m.name),p.show(m))}),s.show(Of(i));let f=i.permissions&&!i.permissions.controllable;o.disabled=a.disabled=!!f,$t(r,i.stale?C_(i):f?"recorded":"live"),An(r,"data-tone",i.stale?"bad":"good")}return{element:l,update:d}}function C_(i){return i.refusal?i.refusal.message:i.connection==="connecting"?"connecting":"no sign of life"}var P_=2e3,I_=5,qo={mean:["u_mean","v_mean","w_mean"],rms:["u_rms","v_rms","w_rms"]};function L_(i){let t=n=>Float32Array.from(n,s=>s??NaN),e=i.maps.map(n=>[n.quantity,{unit:n.unit,value:t(n.value),low:t(n.low),high:t(n.high),flow:t(n.flow_uncertainty),measurement:t(n.measurement_uncertainty)}]);return{shots:i.shots,n:i.grid.vectors_xyz,first:i.grid.first_mm,spacing:i.grid.spacing_mm,samples:Float32Array.from(i.samples),maps:Object.fromEntries(e),convergence:i.convergence,correlations:i.correlations}}function qh(i,t,e=(n,s)=>n.value[s]){let n=t.map(r=>i.maps[r]),s=new Float32Array(3*i.samples.length);for(let r=0;r<3;r+=1)for(let o=0;o<i.samples.length;o+=1)s[3*o+r]=e(n[r],o);return s}var nl=(i,t)=>Math.hypot(i.flow[t],i.measurement[t]),Yh=(i,t)=>(i.high[t]-i.low[t])/2,el=class{constructor(t){this.run=t,this.listeners=new Set,this.busy=!1,this.restMs=0,this.lastAsked=-1/0,this.clear(),t.watchResults(e=>{e===null&&this.clear()})}clear(){this.now=null,this.error=null,this.measured=null}watch(t){this.listeners.add(t)}has(t){return!!this.now&&t.every(e=>this.now.maps[e])}async want(t){let e=this.run.status?.shots.done??0,n=performance.now()-this.lastAsked>this.restMs,s=this.measured!==e||(this.now?.shots??0)<e;if(this.busy||document.hidden||this.has(t)&&!(n&&s)||this.error&&!n)return;this.busy=!0;let r=performance.now();this.lastAsked=r;try{this.now=L_(await Li(`/api/v1/statistics?quantities=${t.join(",")}`)),this.measured=e,this.error=null}catch(o){this.error=o instanceof on?o.message:"the daemon does not answer"}finally{this.busy=!1,this.restMs=Math.max(P_,I_*(performance.now()-r)),this.listeners.forEach(o=>o())}}};var D_={auto:"light",light:"dark",dark:"auto"};function kf(){let i="auto",t=q("button",{type:"button",class:"quiet theme",onclick:()=>e(D_[i])},"Theme: auto");function e(n){i=n,$t(t,`Theme: ${n}`),n==="auto"?document.documentElement.removeAttribute("data-theme"):document.documentElement.setAttribute("data-theme",n),document.dispatchEvent(new Event("themechange"))}return t}var N_="LFPIVVF2";function $h(i){let t=new DataView(i),e=String.fromCharCode(...new Uint8Array(i,0,8));if(e!==N_)throw new Error(`a field of another version: ${e}`);let n=[16,20,24].map(y=>t.getUint32(y,!0)),s=n[0]*n[1]*n[2],r=t.getUint32(28,!0),[o,a,c,l]=[[32,40,48].map(y=>t.getFloat64(y,!0)),t.getFloat64(56,!0),t.getFloat64(64,!0),t.getFloat64(72,!0)],h=new Float32Array(i,r,3*s),d=new Uint8Array(i,r+16*s,s),u=Math.ceil((r+17*s)/4)*4,f=c*.001/l,p=y=>y.map(m=>m*f);return{shot:Number(t.getBigUint64(8,!0)),n,first:o,spacing:a,voxel:c,dt:l,displacement:h,status:d,u:p(h),uncertainty:p(new Float32Array(i,u,3*s))}}var U_=1e-6;function zf(i,t){let e=(n,s)=>Math.abs(n-s)<U_;return!!(i&&t)&&e(i.spacing,t.spacing)&&i.n.every((n,s)=>n===t.n[s]&&e(i.first[s],t.first[s]))}var kr=(i,t,e,n)=>t+i.n[0]*(e+i.n[1]*n);function zr(i){let t=new Float32Array(i.length/3);for(let e=0;e<t.length;e+=1)t[e]=Math.hypot(i[3*e],i[3*e+1],i[3*e+2]);return t}function Zh(i,t){let e=new Float32Array(i.length/3);for(let n=0;n<e.length;n+=1)e[n]=i[3*n+t];return e}function Vf(i,t=i.u){let{n:e,spacing:n}=i,s=[1,e[0],e[0]*e[1]],r=new Float32Array(t.length);for(let o=0;o<e[2];o+=1)for(let a=0;a<e[1];a+=1)for(let c=0;c<e[0];c+=1){let l=kr(i,c,a,o),h=[c,a,o],d=(u,f)=>{let p=R=>h[f]+R>=0&&h[f]+R<e[f]?t[3*(l+R*s[f])+u]:NaN,[y,m,g]=[p(-1),p(0),p(1)];if(m!==m)return NaN;let v=n*.001;return y===y&&g===g?(g-y)/(2*v):g===g?(g-m)/v:(m-y)/v};r[3*l]=d(2,1)-d(1,2),r[3*l+1]=d(0,2)-d(2,0),r[3*l+2]=d(1,0)-d(0,1)}return r}function kn(i,t){let e=Float32Array.from(i).filter(n=>n===n).sort();return e.length?e[Math.min(e.length-1,Math.floor(t*e.length))]:NaN}function Jh(i){return i.status.reduce((t,e)=>t+(e!==3),0)}function Gf(i){let t=0;for(let e of i.status)t+=e===0;return t/Math.max(1,Jh(i))}var F_=250,il=class{constructor(t){this.run=t,this.field=null,this.held=null,this.error=null,this.listeners=new Set,this.wanted=null,this.busy=!1,this.lastFetch=-1/0,t.watchResults(e=>this.isReady(e))}watch(t){this.listeners.add(t)}tell(){this.listeners.forEach(t=>t())}isReady(t){if(t===null){this.field=this.held=this.wanted=null,this.tell();return}this.wanted=t,this.fetchWanted()}hold(t){this.held=t,t===null?(this.wanted=this.run.latestResult,this.fetchWanted()):this.fetchHeld(t),this.tell()}async fetchWanted(){if(this.busy||this.wanted===null||this.held!==null||document.hidden)return;let t=F_-(performance.now()-this.lastFetch);if(t>0){this.timer??=setTimeout(()=>{this.timer=null,this.fetchWanted()},t);return}let e=this.wanted;this.wanted=null,this.busy=!0,this.lastFetch=performance.now();try{let n=$h(await rr(`/api/v1/results/${e}?format=binary`));this.held===null&&(this.field=n),this.error=null,this.tell()}catch(n){this.fail(n)}finally{this.busy=!1,this.fetchWanted()}}async fetchHeld(t){try{let e=$h(await rr(`/api/v1/results/${t}?format=binary`));this.held===t&&(this.field=e),this.error=null}catch(e){this.fail(e)}this.tell()}fail(t){this.error=t instanceof on?t.message:"the daemon does not answer",this.tell()}};var O_="uplot",B_="u-hz",k_="u-vt",z_="u-title",V_="u-wrap",G_="u-under",H_="u-over",W_="u-axis",cr="u-off",X_="u-select",q_="u-cursor-x",Y_="u-cursor-y",$_="u-cursor-pt",Z_="u-legend",J_="u-live",K_="u-inline",j_="u-series",Q_="u-marker",Hf="u-label",tx="u-value",$o="width",Zo="height";var Wf="bottom",Vr="left",Kh="right",pu="#000",Xf=pu+"0",jh="mousemove",qf="mousedown",Qh="mouseup",Yf="mouseenter",$f="mouseleave",Zf="dblclick",ex="resize",nx="scroll",Jf="change",ll="dppxchange",mu="--",$r=typeof window<"u",su=$r?document:null,Hr=$r?window:null,ix=$r?navigator:null,Ee,sl;function ru(){let i=devicePixelRatio;Ee!=i&&(Ee=i,sl&&au(Jf,sl,ru),sl=matchMedia(`(min-resolution: ${Ee-.001}dppx) and (max-resolution: ${Ee+.001}dppx)`),hr(Jf,sl,ru),Hr.dispatchEvent(new CustomEvent(ll)))}function di(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function ou(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function qe(i,t,e){i.style[t]=e+"px"}function Di(i,t,e,n){let s=su.createElement(i);return t!=null&&di(s,t),e?.insertBefore(s,n),s}function Mi(i,t){return Di("div",i,t)}var Kf=new WeakMap;function Ji(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=Kf.get(i);r!=o&&(i.style.transform=r,Kf.set(i,r),t<0||e<0||t>n||e>s?di(i,cr):ou(i,cr))}var jf=new WeakMap;function Qf(i,t,e){let n=t+e,s=jf.get(i);n!=s&&(jf.set(i,n),i.style.background=t,i.style.borderColor=e)}var tp=new WeakMap;function ep(i,t,e,n){let s=t+""+e,r=tp.get(i);s!=r&&(tp.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var gu={passive:!0},sx={...gu,capture:!0};function hr(i,t,e,n){t.addEventListener(i,e,n?sx:gu)}function au(i,t,e,n){t.removeEventListener(i,e,gu)}$r&&ru();function Ni(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:fi((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function Cp(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var Pp=i=>i!=null,Ip=i=>i!=null&&i>0,ul=Cp(Pp),rx=Cp(Ip);function ox(i,t,e,n=0,s=!1){let r=s?rx:ul,o=s?Ip:Pp;[t,e]=r(i,t,e);let a=i[t],c=i[t];if(t>-1)if(n==1)a=i[t],c=i[e];else if(n==-1)a=i[e],c=i[t];else for(let l=t;l<=e;l++){let h=i[l];o(h)&&(h<a?a=h:h>c&&(c=h))}return[a??ke,c??-ke]}function dl(i,t,e,n){let s=sp(i),r=sp(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?us:Lp,a=s==1?fi:wi,c=r==1?wi:fi,l=a(o(_n(i))),h=c(o(_n(t))),d=Wr(e,l),u=Wr(e,h);return e==10&&(l<0&&(d=ze(d,-l)),h<0&&(u=ze(u,-h))),n||e==2?(i=d*s,t=u*r):(i=Fp(i,d),t=fl(t,u)),[i,t]}function _u(i,t,e,n){let s=dl(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var xu=.1,np={mode:3,pad:xu},Ko={pad:0,soft:null,mode:0},ax={min:Ko,max:Ko};function cl(i,t,e,n){return pl(e)?ip(i,t,e):(Ko.pad=e,Ko.soft=n?0:null,Ko.mode=n?3:0,ip(i,t,ax))}function we(i,t){return i??t}function lx(i,t,e){for(t=we(t,0),e=we(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function ip(i,t,e){let n=e.min,s=e.max,r=we(n.pad,0),o=we(s.pad,0),a=we(n.hard,-ke),c=we(s.hard,ke),l=we(n.soft,ke),h=we(s.soft,-ke),d=we(n.mode,0),u=we(s.mode,0),f=t-i,p=us(f),y=Qn(_n(i),_n(t)),m=us(y),g=_n(m-p);(f<1e-24||g>10)&&(f=0,(i==0||t==0)&&(f=1e-24,d==2&&l!=ke&&(r=0),u==2&&h!=-ke&&(o=0)));let v=f||y||1e3,R=us(v),S=Wr(10,fi(R)),C=v*(f==0?i==0?.1:1:r),M=ze(Fp(i-C,S/10),24),_=i>=l&&(d==1||d==3&&M<=l||d==2&&M>=l)?l:ke,b=Qn(a,M<_&&i>=_?_:Ui(_,M)),F=v*(f==0?t==0?.1:1:o),A=ze(fl(t+F,S/10),24),P=t<=h&&(u==1||u==3&&A>=h||u==2&&A<=h)?h:-ke,D=Ui(c,A>P&&t<=P?P:Qn(P,A));return b==D&&b==0&&(D=100),[b,D]}var cx=new Intl.NumberFormat($r?ix.language:"en-US"),vu=i=>cx.format(i),pi=Math,al=pi.PI,_n=pi.abs,fi=pi.floor,gn=pi.round,wi=pi.ceil,Ui=pi.min,Qn=pi.max,Wr=pi.pow,sp=pi.sign,us=pi.log10,Lp=pi.log2,hx=(i,t=1)=>pi.sinh(i)*t,tu=(i,t=1)=>pi.asinh(i/t),ke=1/0;function rp(i){return(us((i^i>>31)-(i>>31))|0)+1}function lu(i,t,e){return Ui(Qn(i,t),e)}function Dp(i){return typeof i=="function"}function ye(i){return Dp(i)?i:()=>i}var ux=()=>{},Np=i=>i,Up=(i,t)=>t,dx=i=>null,op=i=>!0,ap=(i,t)=>i==t,fx=/\.\d*?(?=9{6,}|0{6,})/gm,ur=i=>{if(Bp(i)||ks.has(i))return i;let t=`${i}`,e=t.match(fx);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${ur(s)}e${r}`}return ze(i,n)};function ar(i,t){return ur(ze(ur(i/t))*t)}function fl(i,t){return ur(wi(ur(i/t))*t)}function Fp(i,t){return ur(fi(ur(i/t))*t)}function ze(i,t=0){if(Bp(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return gn(n)/e}var ks=new Map;function Op(i){return((""+i).split(".")[1]||"").length}function Qo(i,t,e,n){let s=[],r=n.map(Op);for(let o=t;o<e;o++){let a=_n(o),c=ze(Wr(i,o),a);for(let l=0;l<n.length;l++){let h=i==10?+`${n[l]}e${o}`:n[l]*c,d=(o>=0?0:a)+(o>=r[l]?0:r[l]),u=i==10?h:ze(h,d);s.push(u),ks.set(u,d)}}return s}var jo={},yu=[],Xr=[null,null],Bs=Array.isArray,Bp=Number.isInteger,px=i=>i===void 0;function lp(i){return typeof i=="string"}function pl(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function mx(i){return i!=null&&typeof i=="object"}var gx=Object.getPrototypeOf(Uint8Array),kp="__proto__";function qr(i,t=pl){let e;if(Bs(i)){let n=i.find(s=>s!=null);if(Bs(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=qr(i[s],t)}else e=i.slice()}else if(i instanceof gx)e=i.slice();else if(t(i)){e={};for(let n in i)n!=kp&&(e[n]=qr(i[n],t))}else e=i;return e}function dn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=kp&&(pl(i[s])?dn(i[s],qr(n[s])):i[s]=qr(n[s]))}return i}var _x=0,xx=1,vx=2;function yx(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function Sx(i,t){if(wx(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return Tx(o[0])||(o=Mx(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let c=i[o][0],l=c.length;for(let h=0;h<l;h++)e.add(c[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],c=a[0];for(let l=1;l<a.length;l++){let h=a[l],d=Array(s).fill(void 0),u=t?t[o][l]:xx,f=[];for(let p=0;p<h.length;p++){let y=h[p],m=r.get(c[p]);y===null?u!=_x&&(d[m]=y,u==vx&&f.push(m)):d[m]=y}yx(d,f,s),n.push(d)}}return n}var bx=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function Mx(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let c=0;c<e;c++)a[c]=o[n[c]];s.push(a)}return s}function wx(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function Tx(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Qn(1,fi((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let c=i[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var zp=["January","February","March","April","May","June","July","August","September","October","November","December"],Vp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Gp(i){return i.slice(0,3)}var Ex=Vp.map(Gp),Ax=zp.map(Gp),Rx={MMMM:zp,MMM:Ax,WWWW:Vp,WWW:Ex};function Yo(i){return(i<10?"0":"")+i}function Cx(i){return(i<10?"00":i<100?"0":"")+i}var Px={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Yo(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Yo(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Yo(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Yo(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Yo(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Cx(i.getMilliseconds())};function Su(i,t){t=t||Rx;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?Px[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var Ix=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Lx(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==Ix?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var Hp=i=>i%1==0,hl=[1,2,2.5,5],Dx=Qo(10,-32,0,hl),Wp=Qo(10,0,32,hl),Nx=Wp.filter(Hp),lr=Dx.concat(Wp),bu=`
`,Xp="{YYYY}",cp=bu+Xp,qp="{M}/{D}",Jo=bu+qp,rl=Jo+"/{YY}",Yp="{aa}",Ux="{h}:{mm}",Gr=Ux+Yp,hp=bu+Gr,up=":{ss}",Pe=null;function $p(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,c=(i==1?Qo(10,0,3,hl).filter(Hp):Qo(10,-3,0,hl)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,Xp,Pe,Pe,Pe,Pe,Pe,Pe,1],[s*28,"{MMM}",cp,Pe,Pe,Pe,Pe,Pe,1],[s,qp,cp,Pe,Pe,Pe,Pe,Pe,1],[n,"{h}"+Yp,rl,Pe,Jo,Pe,Pe,Pe,1],[e,Gr,rl,Pe,Jo,Pe,Pe,Pe,1],[t,up,rl+" "+Gr,Pe,Jo+" "+Gr,Pe,hp,Pe,1],[i,up+".{fff}",rl+" "+Gr,Pe,Jo+" "+Gr,Pe,hp,Pe,1]];function h(d){return(u,f,p,y,m,g)=>{let v=[],R=m>=o,S=m>=r&&m<o,C=d(p),M=ze(C*i,3),_=eu(C.getFullYear(),R?0:C.getMonth(),S||R?1:C.getDate()),b=ze(_*i,3);if(S||R){let F=S?m/r:0,A=R?m/o:0,P=M==b?M:ze(eu(_.getFullYear()+A,_.getMonth()+F,1)*i,3),D=new Date(gn(P/i)),O=D.getFullYear(),I=D.getMonth();for(let V=0;P<=y;V++){let H=eu(O+A*V,I+F*V,1),z=H-d(ze(H*i,3));P=ze((+H+z)*i,3),P<=y&&v.push(P)}}else{let F=m>=s?s:m,A=fi(p)-fi(M),P=b+A+fl(M-b,F);v.push(P);let D=d(P),O=D.getHours()+D.getMinutes()/e+D.getSeconds()/n,I=m/n,V=u.axes[f]._space,H=g/V;for(;P=ze(P+m,i==1?0:3),!(P>y);)if(I>1){let z=fi(ze(O+I,6))%24,J=d(P).getHours()-z;J>1&&(J=-1),P-=J*n,O=(O+I)%24;let G=v[v.length-1];ze((P-G)/m,3)*H>=.7&&v.push(P)}else v.push(P)}return v}}return[c,l,h]}var[Fx,Ox,Bx]=$p(1),[kx,zx,Vx]=$p(.001);Qo(2,-53,53,[1]);function dp(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function fp(i,t){return(e,n,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],c,l,h,d,u,f;return n.map(p=>{let y=i(p),m=y.getFullYear(),g=y.getMonth(),v=y.getDate(),R=y.getHours(),S=y.getMinutes(),C=y.getSeconds(),M=m!=c&&a[2]||g!=l&&a[3]||v!=h&&a[4]||R!=d&&a[5]||S!=u&&a[6]||C!=f&&a[7]||a[1];return c=m,l=g,h=v,d=R,u=S,f=C,M(y)})}}function Gx(i,t){let e=Su(t);return(n,s,r,o,a)=>s.map(c=>e(i(c)))}function eu(i,t,e){return new Date(i,t,e)}function pp(i,t){return t(i)}var Hx="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function mp(i,t){return(e,n,s,r)=>r==null?mu:t(i(n))}function Wx(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function Xx(i,t){return i.series[t].fill(i,t)}var qx={show:!0,live:!0,isolate:!1,mount:ux,markers:{show:!0,width:2,stroke:Wx,fill:Xx,dash:"solid"},idx:null,idxs:null,values:[]};function Yx(i,t){let e=i.cursor.points,n=Mi(),s=e.size(i,t);qe(n,$o,s),qe(n,Zo,s);let r=s/-2;qe(n,"marginLeft",r),qe(n,"marginTop",r);let o=e.width(i,t,s);return o&&qe(n,"borderWidth",o),n}function $x(i,t){let e=i.series[t].points;return e._fill||e._stroke}function Zx(i,t){let e=i.series[t].points;return e._stroke||e._fill}function Jx(i,t){return i.series[t].points.size}var nu=[0,0];function Kx(i,t,e){return nu[0]=t,nu[1]=e,nu}function ol(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function iu(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var jx={show:!0,x:!0,y:!0,lock:!1,move:Kx,points:{one:!1,show:Yx,size:Jx,width:0,stroke:Zx,fill:$x},bind:{mousedown:ol,mouseup:ol,click:ol,dblclick:ol,mousemove:iu,mouseleave:iu,mouseenter:iu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Zp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Mu=dn({},Zp,{filter:Up}),Jp=dn({},Mu,{size:10}),Kp=dn({},Zp,{show:!1}),wu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',jp="bold "+wu,Qp=1.5,gp={show:!0,scale:"x",stroke:pu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:jp,side:2,grid:Mu,ticks:Jp,border:Kp,font:wu,lineGap:Qp,rotate:0},Qx="Value",tv="Time",_p={show:!0,scale:"x",auto:!1,sorted:1,min:ke,max:-ke,idxs:[]};function ev(i,t,e,n,s){return t.map(r=>r==null?"":vu(r))}function nv(i,t,e,n,s,r,o){let a=[],c=ks.get(s)||0;e=o?e:ze(fl(e,s),c);for(let l=e;l<=n;l=ze(l+s,c))a.push(Object.is(l,-0)?0:l);return a}function cu(i,t,e,n,s,r,o){let a=[],c=i.scales[i.axes[t].scale].log,l=c==10?us:Lp,h=fi(l(e));s=Wr(c,h),c==10&&(s=lr[Ni(s,lr)]);let d=e,u=s*c;c==10&&(u=lr[Ni(u,lr)]);do a.push(d),d=d+s,c==10&&!ks.has(d)&&(d=ze(d,ks.get(s))),d>=u&&(s=d,u=s*c,c==10&&(u=lr[Ni(u,lr)]));while(d<=n);return a}function iv(i,t,e,n,s,r,o){let c=i.scales[i.axes[t].scale].asinh,l=n>c?cu(i,t,Qn(c,e),n,s):[c],h=n>=0&&e<=0?[0]:[];return(e<-c?cu(i,t,Qn(c,-n),-e,s):[c]).reverse().map(u=>-u).concat(h,l)}var tm=/./,sv=/[12357]/,rv=/[125]/,xp=/1/,hu=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function ov(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],c=i.valToPos,l=r._space,h=c(10,o),d=c(9,o)-h>=l?tm:c(7,o)-h>=l?sv:c(5,o)-h>=l?rv:xp;if(d==xp){let u=_n(c(1,o)-h);if(u<l)return hu(t.slice().reverse(),a.distr,d,wi(l/u)).reverse()}return hu(t,a.distr,d,1)}function av(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,c=i.valToPos,l=_n(c(1,o)-c(2,o));return l<a?hu(t.slice().reverse(),3,tm,wi(a/l)).reverse():t}function lv(i,t,e,n){return n==null?mu:t==null?"":vu(t)}var vp={show:!0,scale:"y",stroke:pu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:jp,side:3,grid:Mu,ticks:Jp,border:Kp,font:wu,lineGap:Qp,rotate:0};function cv(i,t){let e=3+(i||1)*2;return ze(e*t,3)}function hv(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=_n(o-r),c=i.series[t],l=a/(c.points.space*Ee);return n[1]-n[0]<=l}var yp={scale:null,auto:!0,sorted:0,min:ke,max:-ke},em=(i,t,e,n,s)=>s,Sp={show:!0,auto:!0,sorted:0,gaps:em,alpha:1,facets:[dn({},yp,{scale:"x"}),dn({},yp,{scale:"y"})]},bp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:em,alpha:1,points:{show:hv,filter:null},values:null,min:ke,max:-ke,idxs:[],path:null,clip:null};function uv(i,t,e,n,s){return e/10}var nm={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},dv=dn({},nm,{time:!1,ori:1}),Mp={};function im(i,t){let e=Mp[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,c,l){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,c,l)}},i!=null&&(Mp[i]=e)),e}var Yr=1,uu=2;function dr(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,c=r[0],l=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],d=n==2?o[s.facets[1].scale]:o[s.scale],u=a.left,f=a.top,p=a.width,y=a.height,m=i.valToPosH,g=i.valToPosV;return h.ori==0?e(s,c,l,h,d,m,g,u,f,p,y,gl,Zr,xl,rm,am):e(s,c,l,h,d,g,m,f,u,y,p,_l,Jr,Au,om,lm)}function Tu(i,t){let e=0,n=0,s=we(i.bands,yu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function fv(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,c=i.scales[a];return s==-1?c.min:s==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function ds(i,t,e,n,s,r){return dr(i,t,(o,a,c,l,h,d,u,f,p,y,m)=>{let g=o.pxRound,v=l.dir*(l.ori==0?1:-1),R=l.ori==0?Zr:Jr,S,C;v==1?(S=e,C=n):(S=n,C=e);let M=g(d(a[S],l,y,f)),_=g(u(c[S],h,m,p)),b=g(d(a[C],l,y,f)),F=g(u(r==1?h.max:h.min,h,m,p)),A=new Path2D(s);return R(A,b,F),R(A,M,F),R(A,M,_),A})}function ml(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?xl:Au,c=e;for(let d=0;d<i.length;d++){let u=i[d];if(u[1]>u[0]){let f=u[0]-c;f>0&&a(o,c,n,f,n+r),c=u[1]}}let l=e+s-c,h=10;l>0&&a(o,c,n-h/2,l,n+r+h)}return o}function pv(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Eu(i,t,e,n,s,r,o){let a=[],c=i.length;for(let l=s==1?e:n;l>=e&&l<=n;l+=s)if(t[l]===null){let d=l,u=l;if(s==1)for(;++l<=n&&t[l]===null;)u=l;else for(;--l>=e&&t[l]===null;)u=l;let f=r(i[d]),p=u==d?f:r(i[u]),y=d-s;f=o<=0&&y>=0&&y<c?r(i[y]):f;let g=u+s;p=o>=0&&g>=0&&g<c?r(i[g]):p,p>=f&&a.push([f,p])}return a}function wp(i){return i==0?Np:i==1?gn:t=>ar(t,i)}function sm(i){let t=i==0?gl:_l,e=i==0?(s,r,o,a,c,l)=>{s.arcTo(r,o,a,c,l)}:(s,r,o,a,c,l)=>{s.arcTo(o,r,c,a,l)},n=i==0?(s,r,o,a,c)=>{s.rect(r,o,a,c)}:(s,r,o,a,c)=>{s.rect(o,r,c,a)};return(s,r,o,a,c,l=0,h=0)=>{l==0&&h==0?n(s,r,o,a,c):(l=Ui(l,a/2,c/2),h=Ui(h,a/2,c/2),t(s,r+l,o),e(s,r+a,o,r+a,o+c,l),e(s,r+a,o+c,r,o+c,h),e(s,r,o+c,r,o,h),e(s,r,o,r+a,o,l),s.closePath())}}var gl=(i,t,e)=>{i.moveTo(t,e)},_l=(i,t,e)=>{i.moveTo(e,t)},Zr=(i,t,e)=>{i.lineTo(t,e)},Jr=(i,t,e)=>{i.lineTo(e,t)},xl=sm(0),Au=sm(1),rm=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},om=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},am=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},lm=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function cm(i){return(t,e,n,s,r)=>dr(t,e,(o,a,c,l,h,d,u,f,p,y,m)=>{let{pxRound:g,points:v}=o,R,S;l.ori==0?(R=gl,S=rm):(R=_l,S=om);let C=ze(v.width*Ee,3),M=(v.size-v.width)/2*Ee,_=ze(M*2,3),b=new Path2D,F=new Path2D,{left:A,top:P,width:D,height:O}=t.bbox;xl(F,A-_,P-_,D+_*2,O+_*2);let I=V=>{if(c[V]!=null){let H=g(d(a[V],l,y,f)),z=g(u(c[V],h,m,p));R(b,H+M,z),S(b,H,z,M,0,al*2)}};if(r)r.forEach(I);else for(let V=n;V<=s;V++)I(V);return{stroke:C>0?b:null,fill:b,clip:F,flags:Yr|uu}})}function hm(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var mv=hm(Zr),gv=hm(Jr);function um(i){let t=we(i?.alignGaps,0);return(e,n,s,r)=>dr(e,n,(o,a,c,l,h,d,u,f,p,y,m)=>{[s,r]=ul(c,s,r);let g=o.pxRound,v=O=>g(d(O,l,y,f)),R=O=>g(u(O,h,m,p)),S,C;l.ori==0?(S=Zr,C=mv):(S=Jr,C=gv);let M=l.dir*(l.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Yr},b=_.stroke,F=!1;if(r-s>=y*4){let O=lt=>e.posToVal(lt,l.key,!0),I=null,V=null,H,z,ot,Y=v(a[M==1?s:r]),J=v(a[s]),G=v(a[r]),nt=O(M==1?J+1:G-1);for(let lt=M==1?s:r;lt>=s&&lt<=r;lt+=M){let j=a[lt],dt=(M==1?j<nt:j>nt)?Y:v(j),gt=c[lt];dt==Y?gt!=null?(z=gt,I==null?(S(b,dt,R(z)),H=I=V=z):z<I?I=z:z>V&&(V=z)):gt===null&&(F=!0):(I!=null&&C(b,Y,R(I),R(V),R(H),R(z)),gt!=null?(z=gt,S(b,dt,R(z)),I=V=H=z):(I=V=null,gt===null&&(F=!0)),Y=dt,nt=O(Y+M))}I!=null&&I!=V&&ot!=Y&&C(b,Y,R(I),R(V),R(H),R(z))}else for(let O=M==1?s:r;O>=s&&O<=r;O+=M){let I=c[O];I===null?F=!0:I!=null&&S(b,v(a[O]),R(I))}let[P,D]=Tu(e,n);if(o.fill!=null||P!=0){let O=_.fill=new Path2D(b),I=o.fillTo(e,n,o.min,o.max,P),V=R(I),H=v(a[s]),z=v(a[r]);M==-1&&([z,H]=[H,z]),S(O,z,V),S(O,H,V)}if(!o.spanGaps){let O=[];F&&O.push(...Eu(a,c,s,r,M,v,t)),_.gaps=O=o.gaps(e,n,s,r,O),_.clip=ml(O,l.ori,f,p,y,m)}return D!=0&&(_.band=D==2?[ds(e,n,s,r,b,-1),ds(e,n,s,r,b,1)]:ds(e,n,s,r,b,D)),_})}function _v(i){let t=we(i.align,1),e=we(i.ascDesc,!1),n=we(i.alignGaps,0),s=we(i.extend,!1);return(r,o,a,c)=>dr(r,o,(l,h,d,u,f,p,y,m,g,v,R)=>{[a,c]=ul(d,a,c);let S=l.pxRound,{left:C,width:M}=r.bbox,_=J=>S(p(J,u,v,m)),b=J=>S(y(J,f,R,g)),F=u.ori==0?Zr:Jr,A={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Yr},P=A.stroke,D=u.dir*(u.ori==0?1:-1),O=b(d[D==1?a:c]),I=_(h[D==1?a:c]),V=I,H=I;s&&t==-1&&(H=C,F(P,H,O)),F(P,I,O);for(let J=D==1?a:c;J>=a&&J<=c;J+=D){let G=d[J];if(G==null)continue;let nt=_(h[J]),lt=b(G);t==1?F(P,nt,O):F(P,V,lt),F(P,nt,lt),O=lt,V=nt}let z=V;s&&t==1&&(z=C+M,F(P,z,O));let[ot,Y]=Tu(r,o);if(l.fill!=null||ot!=0){let J=A.fill=new Path2D(P),G=l.fillTo(r,o,l.min,l.max,ot),nt=b(G);F(J,z,nt),F(J,H,nt)}if(!l.spanGaps){let J=[];J.push(...Eu(h,d,a,c,D,_,n));let G=l.width*Ee/2,nt=e||t==1?G:-G,lt=e||t==-1?-G:G;J.forEach(j=>{j[0]+=nt,j[1]+=lt}),A.gaps=J=l.gaps(r,o,a,c,J),A.clip=ml(J,u.ori,m,g,v,R)}return Y!=0&&(A.band=Y==2?[ds(r,o,a,c,P,-1),ds(r,o,a,c,P,1)]:ds(r,o,a,c,P,Y)),A})}function Tp(i,t,e,n,s,r,o=ke){if(i.length>1){let a=null;for(let c=0,l=1/0;c<i.length;c++)if(t[c]!==void 0){if(a!=null){let h=_n(i[c]-i[a]);h<l&&(l=h,o=_n(e(i[c],n,s,r)-e(i[a],n,s,r)))}a=c}}return o}function xv(i){i=i||jo;let t=we(i.size,[.6,ke,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=ye(s),o=1-t[0],a=we(t[1],ke),c=we(t[2],1),l=we(i.disp,jo),h=we(i.each,f=>{}),{fill:d,stroke:u}=l;return(f,p,y,m)=>dr(f,p,(g,v,R,S,C,M,_,b,F,A,P)=>{let D=g.pxRound,O=e,I=n*Ee,V=a*Ee,H=c*Ee,z,ot;S.ori==0?[z,ot]=r(f,p):[ot,z]=r(f,p);let Y=S.dir*(S.ori==0?1:-1),J=S.ori==0?xl:Au,G=S.ori==0?h:(Ct,Kt,ce,wt,Oe,Wt,Zt)=>{h(Ct,Kt,ce,Oe,wt,Zt,Wt)},nt=we(f.bands,yu).find(Ct=>Ct.series[0]==p),lt=nt!=null?nt.dir:0,j=g.fillTo(f,p,g.min,g.max,lt),ut=D(_(j,C,P,F)),dt,gt,pt,Dt=A,qt=D(g.width*Ee),Ft=!1,oe=null,he=null,Qt=null,Ve=null;d!=null&&(qt==0||u!=null)&&(Ft=!0,oe=d.values(f,p,y,m),he=new Map,new Set(oe).forEach(Ct=>{Ct!=null&&he.set(Ct,new Path2D)}),qt>0&&(Qt=u.values(f,p,y,m),Ve=new Map,new Set(Qt).forEach(Ct=>{Ct!=null&&Ve.set(Ct,new Path2D)})));let{x0:Ce,size:Ke}=l;if(Ce!=null&&Ke!=null){O=1,v=Ce.values(f,p,y,m),Ce.unit==2&&(v=v.map(ce=>f.posToVal(b+ce*A,S.key,!0)));let Ct=Ke.values(f,p,y,m);Ke.unit==2?gt=Ct[0]*A:gt=M(Ct[0],S,A,b)-M(0,S,A,b),Dt=Tp(v,R,M,S,A,b,Dt),pt=Dt-gt+I}else Dt=Tp(v,R,M,S,A,b,Dt),pt=Dt*o+I,gt=Dt-pt;pt<1&&(pt=0),qt>=gt/2&&(qt=0),pt<5&&(D=Np);let Ue=pt>0,bn=Dt-pt-(Ue?qt:0);gt=D(lu(bn,H,V)),dt=(O==0?gt/2:O==Y?0:gt)-O*Y*((O==0?I/2:0)+(Ue?qt/2:0));let be={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},pn=Ft?null:new Path2D,je=null;if(nt!=null)je=f.data[nt.series[1]];else{let{y0:Ct,y1:Kt}=l;Ct!=null&&Kt!=null&&(R=Kt.values(f,p,y,m),je=Ct.values(f,p,y,m))}let an=z*gt,k=ot*gt;for(let Ct=Y==1?y:m;Ct>=y&&Ct<=m;Ct+=Y){let Kt=R[Ct];if(Kt==null)continue;if(je!=null){let Z=je[Ct]??0;if(Kt-Z==0)continue;ut=_(Z,C,P,F)}let ce=S.distr!=2||l!=null?v[Ct]:Ct,wt=M(ce,S,A,b),Oe=_(we(Kt,j),C,P,F),Wt=D(wt-dt),Zt=D(Qn(Oe,ut)),L=D(Ui(Oe,ut)),w=Zt-L;if(Kt!=null){let Z=Kt<0?k:an,mt=Kt<0?an:k;Ft?(qt>0&&Qt[Ct]!=null&&J(Ve.get(Qt[Ct]),Wt,L+fi(qt/2),gt,Qn(0,w-qt),Z,mt),oe[Ct]!=null&&J(he.get(oe[Ct]),Wt,L+fi(qt/2),gt,Qn(0,w-qt),Z,mt)):J(pn,Wt,L+fi(qt/2),gt,Qn(0,w-qt),Z,mt),G(f,p,Ct,Wt-qt/2,L,gt+qt,w)}}return qt>0?be.stroke=Ft?Ve:pn:Ft||(be._fill=g.width==0?g._fill:g._stroke??g._fill,be.width=0),be.fill=Ft?he:pn,be})}function vv(i,t){let e=we(t?.alignGaps,0);return(n,s,r,o)=>dr(n,s,(a,c,l,h,d,u,f,p,y,m,g)=>{[r,o]=ul(l,r,o);let v=a.pxRound,R=z=>v(u(z,h,m,p)),S=z=>v(f(z,d,g,y)),C,M,_;h.ori==0?(C=gl,_=Zr,M=am):(C=_l,_=Jr,M=lm);let b=h.dir*(h.ori==0?1:-1),F=R(c[b==1?r:o]),A=F,P=[],D=[];for(let z=b==1?r:o;z>=r&&z<=o;z+=b)if(l[z]!=null){let Y=c[z],J=R(Y);P.push(A=J),D.push(S(l[z]))}let O={stroke:i(P,D,C,_,M,v),fill:null,clip:null,band:null,gaps:null,flags:Yr},I=O.stroke,[V,H]=Tu(n,s);if(a.fill!=null||V!=0){let z=O.fill=new Path2D(I),ot=a.fillTo(n,s,a.min,a.max,V),Y=S(ot);_(z,A,Y),_(z,F,Y)}if(!a.spanGaps){let z=[];z.push(...Eu(c,l,r,o,b,R,e)),O.gaps=z=a.gaps(n,s,r,o,z),O.clip=ml(z,h.ori,p,y,m,g)}return H!=0&&(O.band=H==2?[ds(n,s,r,o,I,-1),ds(n,s,r,o,I,1)]:ds(n,s,r,o,I,H)),O})}function yv(i){return vv(Sv,i)}function Sv(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let c=Array(o),l=Array(o-1),h=Array(o-1),d=Array(o-1);for(let u=0;u<o-1;u++)h[u]=t[u+1]-t[u],d[u]=i[u+1]-i[u],l[u]=h[u]/d[u];c[0]=l[0];for(let u=1;u<o-1;u++)l[u]===0||l[u-1]===0||l[u-1]>0!=l[u]>0?c[u]=0:(c[u]=3*(d[u-1]+d[u])/((2*d[u]+d[u-1])/l[u-1]+(d[u]+2*d[u-1])/l[u]),isFinite(c[u])||(c[u]=0));c[o-1]=l[o-2];for(let u=0;u<o-1;u++)s(a,i[u]+d[u]/3,t[u]+c[u]*d[u]/3,i[u+1]-d[u]/3,t[u+1]-c[u+1]*d[u]/3,i[u+1],t[u+1])}return a}var du=new Set;function Ep(){for(let i of du)i.syncRect(!0)}$r&&(hr(ex,Hr,Ep),hr(nx,Hr,Ep,!0),hr(ll,Hr,()=>{Pn.pxRatio=Ee}));var bv=um(),Mv=cm();function Ap(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>fu(r,o,t,e))}function wv(i,t){return i.map((e,n)=>n==0?{}:dn({},t,e))}function fu(i,t,e,n){return dn({},t==0?e:n,i)}function dm(i,t,e){return t==null?Xr:[t,e]}var Tv=dm;function Ev(i,t,e){return t==null?Xr:cl(t,e,xu,!0)}function fm(i,t,e,n){return t==null?Xr:dl(t,e,i.scales[n].log,!1)}var Av=fm;function pm(i,t,e,n){return t==null?Xr:_u(t,e,i.scales[n].log,!1)}var Rv=pm;function Cv(i,t,e,n,s){let r=Qn(rp(i),rp(t)),o=t-i,a=Ni(s/n*o,e);do{let c=e[a],l=n*c/o;if(l>=s&&r+(c<5?ks.get(c):0)<=17)return[c,l]}while(++a<e.length);return[0,0]}function Rp(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=gn((e=+s)*Ee))+"px"),[i,t,e]}function Pv(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=ze(t[2]*Ee,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Pn(i,t,e){let n={mode:we(i.mode,1)},s=n.mode;function r(x,T,N,U){let X=T.valToPct(x);return U+N*(T.dir==-1?1-X:X)}function o(x,T,N,U){let X=T.valToPct(x);return U+N*(T.dir==-1?X:1-X)}function a(x,T,N,U){return T.ori==0?r(x,T,N,U):o(x,T,N,U)}n.valToPosH=r,n.valToPosV=o;let c=!1;n.status=0;let l=n.root=Mi(O_);if(i.id!=null&&(l.id=i.id),di(l,i.class),i.title){let x=Mi(z_,l);x.textContent=i.title}let h=Di("canvas"),d=n.ctx=h.getContext("2d"),u=Mi(V_,l);hr("click",u,x=>{x.target===p&&(He!=Nr||$e!=Ur)&&Nn.click(n,x)},!0);let f=n.under=Mi(G_,u);u.appendChild(h);let p=n.over=Mi(H_,u);i=qr(i);let y=+we(i.pxAlign,1),m=wp(y);(i.plugins||[]).forEach(x=>{x.opts&&(i=x.opts(n,i)||i)});let g=i.ms||.001,v=n.series=s==1?Ap(i.series||[],_p,bp,!1):wv(i.series||[null],Sp),R=n.axes=Ap(i.axes||[],gp,vp,!0),S=n.scales={},C=n.bands=i.bands||[];C.forEach(x=>{x.fill=ye(x.fill||null),x.dir=we(x.dir,-1)});let M=s==2?v[1].facets[0].scale:v[0].scale,_={axes:as,series:ge},b=(i.drawOrder||["axes","series"]).map(x=>_[x]);function F(x){let T=x.distr==3?N=>us(N>0?N:x.clamp(n,N,x.min,x.max,x.key)):x.distr==4?N=>tu(N,x.asinh):x.distr==100?N=>x.fwd(N):N=>N;return N=>{let U=T(N),{_min:X,_max:tt}=x,ht=tt-X;return(U-X)/ht}}function A(x){let T=S[x];if(T==null){let N=(i.scales||jo)[x]||jo;if(N.from!=null){A(N.from);let U=dn({},S[N.from],N,{key:x});U.valToPct=F(U),S[x]=U}else{T=S[x]=dn({},x==M?nm:dv,N),T.key=x;let U=T.time,X=T.range,tt=Bs(X);if((x!=M||s==2&&!U)&&(tt&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?np:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?np:{mode:1,hard:X[1],soft:X[1]}},tt=!1),!tt&&pl(X))){let ht=X;X=(_t,bt,Nt)=>bt==null?Xr:cl(bt,Nt,ht)}T.range=ye(X||(U?Tv:x==M?T.distr==3?Av:T.distr==4?Rv:dm:T.distr==3?fm:T.distr==4?pm:Ev)),T.auto=ye(tt?!1:T.auto),T.clamp=ye(T.clamp||uv),T._min=T._max=null,T.valToPct=F(T)}}}A("x"),A("y"),s==1&&v.forEach(x=>{A(x.scale)}),R.forEach(x=>{A(x.scale)});for(let x in i.scales)A(x);let P=S[M],D=P.distr,O,I;P.ori==0?(di(l,B_),O=r,I=o):(di(l,k_),O=o,I=r);let V={};for(let x in S){let T=S[x];(T.min!=null||T.max!=null)&&(V[x]={min:T.min,max:T.max},T.min=T.max=null)}let H=i.tzDate||(x=>new Date(gn(x/g))),z=i.fmtDate||Su,ot=g==1?Bx(H):Vx(H),Y=fp(H,dp(g==1?Ox:zx,z)),J=mp(H,pp(Hx,z)),G=[],nt=n.legend=dn({},qx,i.legend),lt=n.cursor=dn({},jx,{drag:{y:s==2}},i.cursor),j=nt.show,ut=lt.show,dt=nt.markers;nt.idxs=G,dt.width=ye(dt.width),dt.dash=ye(dt.dash),dt.stroke=ye(dt.stroke),dt.fill=ye(dt.fill);let gt,pt,Dt,qt=[],Ft=[],oe,he=!1,Qt={};if(nt.live){let x=v[1]?v[1].values:null;he=x!=null,oe=he?x(n,1,0):{_:0};for(let T in oe)Qt[T]=mu}if(j)if(gt=Di("table",Z_,l),Dt=Di("tbody",null,gt),nt.mount(n,gt),he){pt=Di("thead",null,gt,Dt);let x=Di("tr",null,pt);Di("th",null,x);for(var Ve in oe)Di("th",Hf,x).textContent=Ve}else di(gt,K_),nt.live&&di(gt,J_);let Ce={show:!0},Ke={show:!1};function Ue(x,T){if(T==0&&(he||!nt.live||s==2))return Xr;let N=[],U=Di("tr",j_,Dt,Dt.childNodes[T]);di(U,x.class),x.show||di(U,cr);let X=Di("th",null,U);if(dt.show){let _t=Mi(Q_,X);if(T>0){let bt=dt.width(n,T);bt&&(_t.style.border=bt+"px "+dt.dash(n,T)+" "+dt.stroke(n,T)),_t.style.background=dt.fill(n,T)}}let tt=Mi(Hf,X);x.label instanceof HTMLElement?tt.appendChild(x.label):tt.textContent=x.label,T>0&&(dt.show||(tt.style.color=x.width>0?dt.stroke(n,T):dt.fill(n,T)),be("click",X,_t=>{if(lt._lock)return;te(_t);let bt=v.indexOf(x);if((_t.ctrlKey||_t.metaKey)!=nt.isolate){let Nt=v.some((Ut,Bt)=>Bt>0&&Bt!=bt&&Ut.show);v.forEach((Ut,Bt)=>{Bt>0&&qi(Bt,Nt?Bt==bt?Ce:Ke:Ce,!0,un.setSeries)})}else qi(bt,{show:!x.show},!0,un.setSeries)},!1),ee&&be(Yf,X,_t=>{lt._lock||(te(_t),qi(v.indexOf(x),Or,!0,un.setSeries))},!1));for(var ht in oe){let _t=Di("td",tx,U);_t.textContent="--",N.push(_t)}return[U,N]}let bn=new Map;function be(x,T,N,U=!0){let X=bn.get(T)||{},tt=lt.bind[x](n,T,N,U);tt&&(hr(x,T,X[x]=tt),bn.set(T,X))}function pn(x,T,N){let U=bn.get(T)||{};for(let X in U)(x==null||X==x)&&(au(X,T,U[X]),delete U[X]);x==null&&bn.delete(T)}let je=0,an=0,k=0,Ct=0,Kt=0,ce=0,wt=Kt,Oe=ce,Wt=k,Zt=Ct,L=0,w=0,Z=0,mt=0;n.bbox={};let ct=!1,yt=!1,St=!1,it=!1,rt=!1,xt=!1;function B(x,T,N){(N||x!=n.width||T!=n.height)&&at(x,T),de(!1),St=!0,yt=!0,On()}function at(x,T){n.width=je=k=x,n.height=an=Ct=T,Kt=ce=0,Mt(),Xt();let N=n.bbox;L=N.left=ar(Kt*Ee,.5),w=N.top=ar(ce*Ee,.5),Z=N.width=ar(k*Ee,.5),mt=N.height=ar(Ct*Ee,.5)}let st=3;function Tt(){let x=!1,T=0;for(;!x;){T++;let N=Ir(T),U=Xi(T);x=T==st||N&&U,x||(at(n.width,n.height),yt=!0)}}function vt({width:x,height:T}){B(x,T)}n.setSize=vt;function Mt(){let x=!1,T=!1,N=!1,U=!1;R.forEach((X,tt)=>{if(X.show&&X._show){let{side:ht,_size:_t}=X,bt=ht%2,Nt=X.label!=null?X.labelSize:0,Ut=_t+Nt;Ut>0&&(bt?(k-=Ut,ht==3?(Kt+=Ut,U=!0):N=!0):(Ct-=Ut,ht==0?(ce+=Ut,x=!0):T=!0))}}),Hi[0]=x,Hi[1]=N,Hi[2]=T,Hi[3]=U,k-=Ci[1]+Ci[3],Kt+=Ci[3],Ct-=Ci[2]+Ci[0],ce+=Ci[0]}function Xt(){let x=Kt+k,T=ce+Ct,N=Kt,U=ce;function X(tt,ht){switch(tt){case 1:return x+=ht,x-ht;case 2:return T+=ht,T-ht;case 3:return N-=ht,N+ht;case 0:return U-=ht,U+ht}}R.forEach((tt,ht)=>{if(tt.show&&tt._show){let _t=tt.side;tt._pos=X(_t,tt._size),tt.label!=null&&(tt._lpos=X(_t,tt.labelSize))}})}if(lt.dataIdx==null){let x=lt.hover,T=x.skip=new Set(x.skip??[]);T.add(void 0);let N=x.prox=ye(x.prox),U=x.bias??=0;lt.dataIdx=(X,tt,ht,_t)=>{if(tt==0)return ht;let bt=ht,Nt=N(X,tt,ht,_t)??ke,Ut=Nt>=0&&Nt<ke,Bt=P.ori==0?k:Ct,ae=lt.left,Te=t[0],Me=t[tt];if(T.has(Me[ht])){bt=null;let xe=null,jt=null,Yt;if(U==0||U==-1)for(Yt=ht;xe==null&&Yt-- >0;)T.has(Me[Yt])||(xe=Yt);if(U==0||U==1)for(Yt=ht;jt==null&&Yt++<Me.length;)T.has(Me[Yt])||(jt=Yt);if(xe!=null||jt!=null)if(Ut){let Xe=xe==null?-1/0:O(Te[xe],P,Bt,0),en=jt==null?1/0:O(Te[jt],P,Bt,0),En=ae-Xe,Fe=en-ae;En<=Fe?En<=Nt&&(bt=xe):Fe<=Nt&&(bt=jt)}else bt=jt==null?xe:xe==null?jt:ht-xe<=jt-ht?xe:jt}else Ut&&_n(ae-O(Te[ht],P,Bt,0))>Nt&&(bt=null);return bt}}let te=x=>{lt.event=x};lt.idxs=G,lt._lock=!1;let ft=lt.points;ft.show=ye(ft.show),ft.size=ye(ft.size),ft.stroke=ye(ft.stroke),ft.width=ye(ft.width),ft.fill=ye(ft.fill);let kt=n.focus=dn({},i.focus||{alpha:.3},lt.focus),ee=kt.prox>=0,Rt=ee&&ft.one,ue=[],Ge=[],$n=[];function Fo(x,T){let N=ft.show(n,T);if(N instanceof HTMLElement)return di(N,$_),di(N,x.class),Ji(N,-10,-10,k,Ct),p.insertBefore(N,ue[T]),N}function Rr(x,T){if(s==1||T>0){let N=s==1&&S[x.scale].time,U=x.value;x.value=N?lp(U)?mp(H,pp(U,z)):U||J:U||lv,x.label=x.label||(N?tv:Qx)}if(Rt||T>0){x.width=x.width==null?1:x.width,x.paths=x.paths||bv||dx,x.fillTo=ye(x.fillTo||fv),x.pxAlign=+we(x.pxAlign,y),x.pxRound=wp(x.pxAlign),x.stroke=ye(x.stroke||null),x.fill=ye(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let N=cv(Qn(1,x.width),1),U=x.points=dn({},{size:N,width:Qn(1,N*.2),stroke:x.stroke,space:N*2,paths:Mv,_stroke:null,_fill:null},x.points);U.show=ye(U.show),U.filter=ye(U.filter),U.fill=ye(U.fill),U.stroke=ye(U.stroke),U.paths=ye(U.paths),U.pxAlign=x.pxAlign}if(j){let N=Ue(x,T);qt.splice(T,0,N[0]),Ft.splice(T,0,N[1]),nt.values.push(null)}if(ut){G.splice(T,0,null);let N=null;Rt?T==0&&(N=Fo(x,T)):T>0&&(N=Fo(x,T)),ue.splice(T,0,N),Ge.splice(T,0,0),$n.splice(T,0,0)}Tn("addSeries",T)}function Ph(x,T){T=T??v.length,x=s==1?fu(x,T,_p,bp):fu(x,T,{},Sp),v.splice(T,0,x),Rr(v[T],T)}n.addSeries=Ph;function qa(x){if(v.splice(x,1),j){nt.values.splice(x,1),Ft.splice(x,1);let T=qt.splice(x,1)[0];pn(null,T.firstChild),T.remove()}ut&&(G.splice(x,1),ue.splice(x,1)[0].remove(),Ge.splice(x,1),$n.splice(x,1)),Tn("delSeries",x)}n.delSeries=qa;let Hi=[!1,!1,!1,!1];function ss(x,T){if(x._show=x.show,x.show){let N=x.side%2,U=S[x.scale];U==null&&(x.scale=N?v[1].scale:M,U=S[x.scale]);let X=U.time;x.size=ye(x.size),x.space=ye(x.space),x.rotate=ye(x.rotate),Bs(x.incrs)&&x.incrs.forEach(ht=>{!ks.has(ht)&&ks.set(ht,Op(ht))}),x.incrs=ye(x.incrs||(U.distr==2?Nx:X?g==1?Fx:kx:lr)),x.splits=ye(x.splits||(X&&U.distr==1?ot:U.distr==3?cu:U.distr==4?iv:nv)),x.stroke=ye(x.stroke),x.grid.stroke=ye(x.grid.stroke),x.ticks.stroke=ye(x.ticks.stroke),x.border.stroke=ye(x.border.stroke);let tt=x.values;x.values=Bs(tt)&&!Bs(tt[0])?ye(tt):X?Bs(tt)?fp(H,dp(tt,z)):lp(tt)?Gx(H,tt):tt||Y:tt||ev,x.filter=ye(x.filter||(U.distr>=3&&U.log==10?ov:U.distr==3&&U.log==2?av:Up)),x.font=Rp(x.font),x.labelFont=Rp(x.labelFont),x._size=x.size(n,null,T,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(Hi[T]=!0,x._el=Mi(W_,u))}}function rs(x,T,N,U){let[X,tt,ht,_t]=N,bt=T%2,Nt=0;return bt==0&&(_t||tt)&&(Nt=T==0&&!X||T==2&&!ht?gn(gp.size/3):0),bt==1&&(X||ht)&&(Nt=T==1&&!tt||T==3&&!_t?gn(vp.size/2):0),Nt}let Oo=n.padding=(i.padding||[rs,rs,rs,rs]).map(x=>ye(we(x,rs))),Ci=n._padding=Oo.map((x,T)=>x(n,T,Hi,0)),Qe,sn=null,rn=null,Wi=s==1?v[0].idxs:null,li=null,Ps=!1;function Bo(x,T){if(t=x??[],n.data=n._data=t,s==2){Qe=0;for(let N=1;N<v.length;N++)Qe+=t[N][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),li=t[0],Qe=li.length;let N=t;if(D==2){N=t.slice();let U=N[0]=Array(Qe);for(let X=0;X<Qe;X++)U[X]=X}n._data=t=N}if(de(!0),Tn("setData"),D==2&&(St=!0),T!==!1){let N=P;N.auto(n,Ps)?ko():Ds(M,N.min,N.max),it=it||lt.left>=0,xt=!0,On()}}n.setData=Bo;function ko(){Ps=!0;let x,T;s==1&&(Qe>0?(sn=Wi[0]=0,rn=Wi[1]=Qe-1,x=t[0][sn],T=t[0][rn],D==2?(x=sn,T=rn):x==T&&(D==3?[x,T]=dl(x,x,P.log,!1):D==4?[x,T]=_u(x,x,P.log,!1):P.time?T=x+gn(86400/g):[x,T]=cl(x,T,xu,!0))):(sn=Wi[0]=x=null,rn=Wi[1]=T=null)),Ds(M,x,T)}let Cr,Is,Pr,E,W,et,K,Q,Et,Pt;function At(x,T,N,U,X,tt){x??=Xf,N??=yu,U??="butt",X??=Xf,tt??="round",x!=Cr&&(d.strokeStyle=Cr=x),X!=Is&&(d.fillStyle=Is=X),T!=Pr&&(d.lineWidth=Pr=T),tt!=W&&(d.lineJoin=W=tt),U!=et&&(d.lineCap=et=U),N!=E&&d.setLineDash(E=N)}function It(x,T,N,U){T!=Is&&(d.fillStyle=Is=T),x!=K&&(d.font=K=x),N!=Q&&(d.textAlign=Q=N),U!=Et&&(d.textBaseline=Et=U)}function Vt(x,T,N,U,X=0){if(U.length>0&&x.auto(n,Ps)&&(T==null||T.min==null)){let tt=we(sn,0),ht=we(rn,U.length-1),_t=N.min==null?ox(U,tt,ht,X,x.distr==3):[N.min,N.max];x.min=Ui(x.min,N.min=_t[0]),x.max=Qn(x.max,N.max=_t[1])}}let ie={min:null,max:null};function me(){for(let U in S){let X=S[U];V[U]==null&&(X.min==null||V[M]!=null&&X.auto(n,Ps))&&(V[U]=ie)}for(let U in S){let X=S[U];V[U]==null&&X.from!=null&&V[X.from]!=null&&(V[U]=ie)}V[M]!=null&&de(!0);let x={};for(let U in V){let X=V[U];if(X!=null){let tt=x[U]=qr(S[U],mx);if(X.min!=null)dn(tt,X);else if(U!=M||s==2)if(Qe==0&&tt.from==null){let ht=tt.range(n,null,null,U);tt.min=ht[0],tt.max=ht[1]}else tt.min=ke,tt.max=-ke}}if(Qe>0){v.forEach((U,X)=>{if(s==1){let tt=U.scale,ht=V[tt];if(ht==null)return;let _t=x[tt];if(X==0){let bt=_t.range(n,_t.min,_t.max,tt);_t.min=bt[0],_t.max=bt[1],sn=Ni(_t.min,t[0]),rn=Ni(_t.max,t[0]),rn-sn>1&&(t[0][sn]<_t.min&&sn++,t[0][rn]>_t.max&&rn--),U.min=li[sn],U.max=li[rn]}else U.show&&U.auto&&Vt(_t,ht,U,t[X],U.sorted);U.idxs[0]=sn,U.idxs[1]=rn}else if(X>0&&U.show&&U.auto){let[tt,ht]=U.facets,_t=tt.scale,bt=ht.scale,[Nt,Ut]=t[X],Bt=x[_t],ae=x[bt];Bt!=null&&Vt(Bt,V[_t],tt,Nt,tt.sorted),ae!=null&&Vt(ae,V[bt],ht,Ut,ht.sorted),U.min=ht.min,U.max=ht.max}});for(let U in x){let X=x[U],tt=V[U];if(X.from==null&&(tt==null||tt.min==null)){let ht=X.range(n,X.min==ke?null:X.min,X.max==-ke?null:X.max,U);X.min=ht[0],X.max=ht[1]}}}for(let U in x){let X=x[U];if(X.from!=null){let tt=x[X.from];if(tt.min==null)X.min=X.max=null;else{let ht=X.range(n,tt.min,tt.max,U);X.min=ht[0],X.max=ht[1]}}}let T={},N=!1;for(let U in x){let X=x[U],tt=S[U];if(tt.min!=X.min||tt.max!=X.max){tt.min=X.min,tt.max=X.max;let ht=tt.distr;tt._min=ht==3?us(tt.min):ht==4?tu(tt.min,tt.asinh):ht==100?tt.fwd(tt.min):tt.min,tt._max=ht==3?us(tt.max):ht==4?tu(tt.max,tt.asinh):ht==100?tt.fwd(tt.max):tt.max,T[U]=N=!0}}if(N){v.forEach((U,X)=>{s==2?X>0&&T.y&&(U._paths=null):T[U.scale]&&(U._paths=null)});for(let U in T)St=!0,Tn("setScale",U);ut&&lt.left>=0&&(it=xt=!0)}for(let U in V)V[U]=null}function zt(x){let T=lu(sn-1,0,Qe-1),N=lu(rn+1,0,Qe-1);for(;x[T]==null&&T>0;)T--;for(;x[N]==null&&N<Qe-1;)N++;return[T,N]}function ge(){if(Qe>0){let x=v.some(T=>T._focus)&&Pt!=kt.alpha;x&&(d.globalAlpha=Pt=kt.alpha),v.forEach((T,N)=>{if(N>0&&T.show&&(Je(N,!1),Je(N,!0),T._paths==null)){let U=Pt;Pt!=T.alpha&&(d.globalAlpha=Pt=T.alpha);let X=s==2?[0,t[N][0].length-1]:zt(t[N]);T._paths=T.paths(n,N,X[0],X[1]),Pt!=U&&(d.globalAlpha=Pt=U)}}),v.forEach((T,N)=>{if(N>0&&T.show){let U=Pt;Pt!=T.alpha&&(d.globalAlpha=Pt=T.alpha),T._paths!=null&&Le(N,!1);{let X=T._paths!=null?T._paths.gaps:null,tt=T.points.show(n,N,sn,rn,X),ht=T.points.filter(n,N,tt,X);(tt||ht)&&(T.points._paths=T.points.paths(n,N,sn,rn,ht),Le(N,!0))}Pt!=U&&(d.globalAlpha=Pt=U),Tn("drawSeries",N)}}),x&&(d.globalAlpha=Pt=1)}}function Je(x,T){let N=T?v[x].points:v[x];N._stroke=N.stroke(n,x),N._fill=N.fill(n,x)}function Le(x,T){let N=T?v[x].points:v[x],{stroke:U,fill:X,clip:tt,flags:ht,_stroke:_t=N._stroke,_fill:bt=N._fill,_width:Nt=N.width}=N._paths;Nt=ze(Nt*Ee,3);let Ut=null,Bt=Nt%2/2;T&&bt==null&&(bt=Nt>0?"#fff":_t);let ae=N.pxAlign==1&&Bt>0;if(ae&&d.translate(Bt,Bt),!T){let Te=L-Nt/2,Me=w-Nt/2,xe=Z+Nt,jt=mt+Nt;Ut=new Path2D,Ut.rect(Te,Me,xe,jt)}T?Ot(_t,Nt,N.dash,N.cap,bt,U,X,ht,tt):De(x,_t,Nt,N.dash,N.cap,bt,U,X,ht,Ut,tt),ae&&d.translate(-Bt,-Bt)}function De(x,T,N,U,X,tt,ht,_t,bt,Nt,Ut){let Bt=!1;bt!=0&&C.forEach((ae,Te)=>{if(ae.series[0]==x){let Me=v[ae.series[1]],xe=t[ae.series[1]],jt=(Me._paths||jo).band;Bs(jt)&&(jt=ae.dir==1?jt[0]:jt[1]);let Yt,Xe=null;Me.show&&jt&&lx(xe,sn,rn)?(Xe=ae.fill(n,Te)||tt,Yt=Me._paths.clip):jt=null,Ot(T,N,U,X,Xe,ht,_t,bt,Nt,Ut,Yt,jt),Bt=!0}}),Bt||Ot(T,N,U,X,tt,ht,_t,bt,Nt,Ut)}let mn=Yr|uu;function Ot(x,T,N,U,X,tt,ht,_t,bt,Nt,Ut,Bt){At(x,T,N,U,X),(bt||Nt||Bt)&&(d.save(),bt&&d.clip(bt),Nt&&d.clip(Nt)),Bt?(_t&mn)==mn?(d.clip(Bt),Ut&&d.clip(Ut),ve(X,ht),ln(x,tt,T)):_t&uu?(ve(X,ht),d.clip(Bt),ln(x,tt,T)):_t&Yr&&(d.save(),d.clip(Bt),Ut&&d.clip(Ut),ve(X,ht),d.restore(),ln(x,tt,T)):(ve(X,ht),ln(x,tt,T)),(bt||Nt||Bt)&&d.restore()}function ln(x,T,N){N>0&&(T instanceof Map?T.forEach((U,X)=>{d.strokeStyle=Cr=X,d.stroke(U)}):T!=null&&x&&d.stroke(T))}function ve(x,T){T instanceof Map?T.forEach((N,U)=>{d.fillStyle=Is=U,d.fill(N)}):T!=null&&x&&d.fill(T)}function os(x,T,N,U){let X=R[x],tt;if(U<=0)tt=[0,0];else{let ht=X._space=X.space(n,x,T,N,U),_t=X._incrs=X.incrs(n,x,T,N,U,ht);tt=Cv(T,N,_t,U,ht)}return X._found=tt}function cn(x,T,N,U,X,tt,ht,_t,bt,Nt){let Ut=ht%2/2;y==1&&d.translate(Ut,Ut),At(_t,ht,bt,Nt,_t),d.beginPath();let Bt,ae,Te,Me,xe=X+(U==0||U==3?-tt:tt);N==0?(ae=X,Me=xe):(Bt=X,Te=xe);for(let jt=0;jt<x.length;jt++)T[jt]!=null&&(N==0?Bt=Te=x[jt]:ae=Me=x[jt],d.moveTo(Bt,ae),d.lineTo(Te,Me));d.stroke(),y==1&&d.translate(-Ut,-Ut)}function Ir(x){let T=!0;return R.forEach((N,U)=>{if(!N.show)return;let X=S[N.scale];if(X.min==null){N._show&&(T=!1,N._show=!1,de(!1));return}else N._show||(T=!1,N._show=!0,de(!1));let tt=N.side,ht=tt%2,{min:_t,max:bt}=X,[Nt,Ut]=os(U,_t,bt,ht==0?k:Ct);if(Ut==0)return;let Bt=X.distr==2,ae=N._splits=N.splits(n,U,_t,bt,Nt,Ut,Bt),Te=X.distr==2?ae.map(Yt=>li[Yt]):ae,Me=X.distr==2?li[ae[1]]-li[ae[0]]:Nt,xe=N._values=N.values(n,N.filter(n,Te,U,Ut,Me),U,Ut,Me);N._rotate=tt==2?N.rotate(n,xe,U,Ut):0;let jt=N._size;N._size=wi(N.size(n,xe,U,x)),jt!=null&&N._size!=jt&&(T=!1)}),T}function Xi(x){let T=!0;return Oo.forEach((N,U)=>{let X=N(n,U,Hi,x);X!=Ci[U]&&(T=!1),Ci[U]=X}),T}function as(){for(let x=0;x<R.length;x++){let T=R[x];if(!T.show||!T._show)continue;let N=T.side,U=N%2,X,tt,ht=T.stroke(n,x),_t=N==0||N==3?-1:1,[bt,Nt]=T._found;if(T.label!=null){let Kn=T.labelGap*_t,ui=gn((T._lpos+Kn)*Ee);It(T.labelFont[0],ht,"center",N==2?"top":Wf),d.save(),U==1?(X=tt=0,d.translate(ui,gn(w+mt/2)),d.rotate((N==3?-al:al)/2)):(X=gn(L+Z/2),tt=ui);let sr=Dp(T.label)?T.label(n,x,bt,Nt):T.label;d.fillText(sr,X,tt),d.restore()}if(Nt==0)continue;let Ut=S[T.scale],Bt=U==0?Z:mt,ae=U==0?L:w,Te=T._splits,Me=Ut.distr==2?Te.map(Kn=>li[Kn]):Te,xe=Ut.distr==2?li[Te[1]]-li[Te[0]]:bt,jt=T.ticks,Yt=T.border,Xe=jt.show?jt.size:0,en=gn(Xe*Ee),En=gn((T.alignTo==2?T._size-Xe-T.gap:T.gap)*Ee),Fe=T._rotate*-al/180,nn=m(T._pos*Ee),ci=(en+En)*_t,Jn=nn+ci;tt=U==0?Jn:0,X=U==1?Jn:0;let Si=T.font[0],Pi=T.align==1?Vr:T.align==2?Kh:Fe>0?Vr:Fe<0?Kh:U==0?"center":N==3?Kh:Vr,$i=Fe||U==1?"middle":N==2?"top":Wf;It(Si,ht,Pi,$i);let hi=T.font[1]*T.lineGap,bi=Te.map(Kn=>m(a(Kn,Ut,Bt,ae))),Ii=T._values;for(let Kn=0;Kn<Ii.length;Kn++){let ui=Ii[Kn];if(ui!=null){U==0?X=bi[Kn]:tt=bi[Kn],ui=""+ui;let sr=ui.indexOf(`
`)==-1?[ui]:ui.split(/\n/gm);for(let jn=0;jn<sr.length;jn++){let Sf=sr[jn];Fe?(d.save(),d.translate(X,tt+jn*hi),d.rotate(Fe),d.fillText(Sf,0,0),d.restore()):d.fillText(Sf,X,tt+jn*hi)}}}jt.show&&cn(bi,jt.filter(n,Me,x,Nt,xe),U,N,nn,en,ze(jt.width*Ee,3),jt.stroke(n,x),jt.dash,jt.cap);let Zi=T.grid;Zi.show&&cn(bi,Zi.filter(n,Me,x,Nt,xe),U,U==0?2:1,U==0?w:L,U==0?mt:Z,ze(Zi.width*Ee,3),Zi.stroke(n,x),Zi.dash,Zi.cap),Yt.show&&cn([nn],[1],U==0?1:0,U==0?1:2,U==1?w:L,U==1?mt:Z,ze(Yt.width*Ee,3),Yt.stroke(n,x),Yt.dash,Yt.cap)}Tn("drawAxes")}function de(x){v.forEach((T,N)=>{N>0&&(T._paths=null,x&&(s==1?(T.min=null,T.max=null):T.facets.forEach(U=>{U.min=null,U.max=null})))})}let tn=!1,Zn=!1,Ne=[];function hn(){Zn=!1;for(let x=0;x<Ne.length;x++)Tn(...Ne[x]);Ne.length=0}function On(){tn||(bx(nf),tn=!0)}function Ya(x,T=!1){tn=!0,Zn=T,x(n),nf(),T&&Ne.length>0&&queueMicrotask(hn)}n.batch=Ya;function nf(){if(ct&&(me(),ct=!1),St&&(Tt(),St=!1),yt){if(qe(f,Vr,Kt),qe(f,"top",ce),qe(f,$o,k),qe(f,Zo,Ct),qe(p,Vr,Kt),qe(p,"top",ce),qe(p,$o,k),qe(p,Zo,Ct),qe(u,$o,je),qe(u,Zo,an),h.width=gn(je*Ee),h.height=gn(an*Ee),R.forEach(({_el:x,_show:T,_size:N,_pos:U,side:X})=>{if(x!=null)if(T){let tt=X===3||X===0?N:0,ht=X%2==1;qe(x,ht?"left":"top",U-tt),qe(x,ht?"width":"height",N),qe(x,ht?"top":"left",ht?ce:Kt),qe(x,ht?"height":"width",ht?Ct:k),ou(x,cr)}else di(x,cr)}),Cr=Is=Pr=W=et=K=Q=Et=E=null,Pt=1,Go(!0),Kt!=wt||ce!=Oe||k!=Wt||Ct!=Zt){de(!1);let x=k/Wt,T=Ct/Zt;if(ut&&!it&&lt.left>=0){lt.left*=x,lt.top*=T,Lr&&Ji(Lr,gn(lt.left),0,k,Ct),Dr&&Ji(Dr,0,gn(lt.top),k,Ct);for(let N=0;N<ue.length;N++){let U=ue[N];U!=null&&(Ge[N]*=x,$n[N]*=T,Ji(U,wi(Ge[N]),wi($n[N]),k,Ct))}}if(We.show&&!rt&&We.left>=0&&We.width>0){We.left*=x,We.width*=x,We.top*=T,We.height*=T;for(let N in Fh)qe(Fr,N,We[N])}wt=Kt,Oe=ce,Wt=k,Zt=Ct}Tn("setSize"),yt=!1}je>0&&an>0&&(d.clearRect(0,0,h.width,h.height),Tn("drawClear"),b.forEach(x=>x()),Tn("draw")),We.show&&rt&&($a(We),rt=!1),ut&&it&&(ir(null,!0,!1),it=!1),nt.show&&nt.live&&xt&&(Nh(),xt=!1),c||(c=!0,n.status=1,Tn("ready")),Ps=!1,tn=!1}n.redraw=(x,T)=>{St=T||!1,x!==!1?Ds(M,P.min,P.max):On()};function Ih(x,T){let N=S[x];if(N.from==null){if(Qe==0){let U=N.range(n,T.min,T.max,x);T.min=U[0],T.max=U[1]}if(T.min>T.max){let U=T.min;T.min=T.max,T.max=U}if(Qe>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;x==M&&N.distr==2&&Qe>0&&(T.min=Ni(T.min,t[0]),T.max=Ni(T.max,t[0]),T.min==T.max&&T.max++),V[x]=T,ct=!0,On()}}n.setScale=Ih;let Lh,Dh,Lr,Dr,sf,rf,Nr,Ur,of,af,He,$e,Ls=!1,Nn=lt.drag,Mn=Nn.x,wn=Nn.y;ut&&(lt.x&&(Lh=Mi(q_,p)),lt.y&&(Dh=Mi(Y_,p)),P.ori==0?(Lr=Lh,Dr=Dh):(Lr=Dh,Dr=Lh),He=lt.left,$e=lt.top);let We=n.select=dn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Fr=We.show?Mi(X_,We.over?p:f):null;function $a(x,T){if(We.show){for(let N in x)We[N]=x[N],N in Fh&&qe(Fr,N,x[N]);T!==!1&&Tn("setSelect")}}n.setSelect=$a;function e_(x){if(v[x].show)j&&ou(qt[x],cr);else if(j&&di(qt[x],cr),ut){let N=Rt?ue[0]:ue[x];N!=null&&Ji(N,-10,-10,k,Ct)}}function Ds(x,T,N){Ih(x,{min:T,max:N})}function qi(x,T,N,U){T.focus!=null&&o_(x),T.show!=null&&v.forEach((X,tt)=>{tt>0&&(x==tt||x==null)&&(X.show=T.show,e_(tt),s==2?(Ds(X.facets[0].scale,null,null),Ds(X.facets[1].scale,null,null)):Ds(X.scale,null,null),On())}),N!==!1&&Tn("setSeries",x,T),U&&Ho("setSeries",n,x,T)}n.setSeries=qi;function n_(x,T){dn(C[x],T)}function i_(x,T){x.fill=ye(x.fill||null),x.dir=we(x.dir,-1),T=T??C.length,C.splice(T,0,x)}function s_(x){x==null?C.length=0:C.splice(x,1)}n.addBand=i_,n.setBand=n_,n.delBand=s_;function r_(x,T){v[x].alpha=T,ut&&ue[x]!=null&&(ue[x].style.opacity=T),j&&qt[x]&&(qt[x].style.opacity=T)}let ls,Ns,nr,Or={focus:!0};function o_(x){if(x!=nr){let T=x==null,N=kt.alpha!=1;v.forEach((U,X)=>{if(s==1||X>0){let tt=T||X==0||X==x;U._focus=T?null:tt,N&&r_(X,tt?1:kt.alpha)}}),nr=x,N&&On()}}j&&ee&&be($f,gt,x=>{lt._lock||(te(x),nr!=null&&qi(null,Or,!0,un.setSeries))});function Yi(x,T,N){let U=S[T];N&&(x=x/Ee-(U.ori==1?ce:Kt));let X=k;U.ori==1&&(X=Ct,x=X-x),U.dir==-1&&(x=X-x);let tt=U._min,ht=U._max,_t=x/X,bt=tt+(ht-tt)*_t,Nt=U.distr;return Nt==3?Wr(10,bt):Nt==4?hx(bt,U.asinh):Nt==100?U.bwd(bt):bt}function a_(x,T){let N=Yi(x,M,T);return Ni(N,t[0],sn,rn)}n.valToIdx=x=>Ni(x,t[0]),n.posToIdx=a_,n.posToVal=Yi,n.valToPos=(x,T,N)=>S[T].ori==0?r(x,S[T],N?Z:k,N?L:0):o(x,S[T],N?mt:Ct,N?w:0),n.setCursor=(x,T,N)=>{He=x.left,$e=x.top,ir(null,T,N)};function lf(x,T){qe(Fr,Vr,We.left=x),qe(Fr,$o,We.width=T)}function cf(x,T){qe(Fr,"top",We.top=x),qe(Fr,Zo,We.height=T)}let zo=P.ori==0?lf:cf,Vo=P.ori==1?lf:cf;function l_(){if(j&&nt.live)for(let x=s==2?1:0;x<v.length;x++){if(x==0&&he)continue;let T=nt.values[x],N=0;for(let U in T)Ft[x][N++].firstChild.nodeValue=T[U]}}function Nh(x,T){if(x!=null&&(x.idxs?x.idxs.forEach((N,U)=>{G[U]=N}):px(x.idx)||G.fill(x.idx),nt.idx=G[0]),j&&nt.live){for(let N=0;N<v.length;N++)(N>0||s==1&&!he)&&c_(N,G[N]);l_()}xt=!1,T!==!1&&Tn("setLegend")}n.setLegend=Nh;function c_(x,T){let N=v[x],U=x==0&&D==2?li:t[x],X;he?X=N.values(n,x,T)??Qt:(X=N.value(n,T==null?null:U[T],x,T),X=X==null?Qt:{_:X}),nt.values[x]=X}function ir(x,T,N){of=He,af=$e,[He,$e]=lt.move(n,He,$e),lt.left=He,lt.top=$e,ut&&(Lr&&Ji(Lr,gn(He),0,k,Ct),Dr&&Ji(Dr,0,gn($e),k,Ct));let U,X=sn>rn;ls=ke,Ns=null;let tt=P.ori==0?k:Ct,ht=P.ori==1?k:Ct;if(He<0||Qe==0||X){U=lt.idx=null;for(let _t=0;_t<v.length;_t++){let bt=ue[_t];bt!=null&&Ji(bt,-10,-10,k,Ct)}ee&&qi(null,Or,!0,x==null&&un.setSeries),nt.live&&(G.fill(U),xt=!0)}else{let _t,bt,Nt;s==1&&(_t=P.ori==0?He:$e,bt=Yi(_t,M),U=lt.idx=Ni(bt,t[0],sn,rn),Nt=O(t[0][U],P,tt,0));let Ut=-10,Bt=-10,ae=0,Te=0,Me=!0,xe="",jt="";for(let Yt=s==2?1:0;Yt<v.length;Yt++){let Xe=v[Yt],en=G[Yt],En=en==null?null:s==1?t[Yt][en]:t[Yt][1][en],Fe=lt.dataIdx(n,Yt,U,bt),nn=Fe==null?null:s==1?t[Yt][Fe]:t[Yt][1][Fe];if(xt=xt||nn!=En||Fe!=en,G[Yt]=Fe,Yt>0&&Xe.show){let ci=Fe==null?-10:Fe==U?Nt:O(s==1?t[0][Fe]:t[Yt][0][Fe],P,tt,0),Jn=nn==null?-10:I(nn,s==1?S[Xe.scale]:S[Xe.facets[1].scale],ht,0);if(ee&&nn!=null){let Si=P.ori==1?He:$e,Pi=_n(kt.dist(n,Yt,Fe,Jn,Si));if(Pi<ls){let $i=kt.bias;if($i!=0){let hi=Yi(Si,Xe.scale),bi=nn>=0?1:-1,Ii=hi>=0?1:-1;Ii==bi&&(Ii==1?$i==1?nn>=hi:nn<=hi:$i==1?nn<=hi:nn>=hi)&&(ls=Pi,Ns=Yt)}else ls=Pi,Ns=Yt}}if(xt||Rt){let Si,Pi;P.ori==0?(Si=ci,Pi=Jn):(Si=Jn,Pi=ci);let $i,hi,bi,Ii,Zi,Kn,ui=!0,sr=ft.bbox;if(sr!=null){ui=!1;let jn=sr(n,Yt);bi=jn.left,Ii=jn.top,$i=jn.width,hi=jn.height}else bi=Si,Ii=Pi,$i=hi=ft.size(n,Yt);if(Kn=ft.fill(n,Yt),Zi=ft.stroke(n,Yt),Rt)Yt==Ns&&ls<=kt.prox&&(Ut=bi,Bt=Ii,ae=$i,Te=hi,Me=ui,xe=Kn,jt=Zi);else{let jn=ue[Yt];jn!=null&&(Ge[Yt]=bi,$n[Yt]=Ii,ep(jn,$i,hi,ui),Qf(jn,Kn,Zi),Ji(jn,wi(bi),wi(Ii),k,Ct))}}}}if(Rt){let Yt=kt.prox,Xe=nr==null?ls<=Yt:ls>Yt||Ns!=nr;if(xt||Xe){let en=ue[0];en!=null&&(Ge[0]=Ut,$n[0]=Bt,ep(en,ae,Te,Me),Qf(en,xe,jt),Ji(en,wi(Ut),wi(Bt),k,Ct))}}}if(We.show&&Ls)if(x!=null){let[_t,bt]=un.scales,[Nt,Ut]=un.match,[Bt,ae]=x.cursor.sync.scales,Te=x.cursor.drag;if(Mn=Te._x,wn=Te._y,Mn||wn){let{left:Me,top:xe,width:jt,height:Yt}=x.select,Xe=x.scales[Bt].ori,en=x.posToVal,En,Fe,nn,ci,Jn,Si=_t!=null&&Nt(_t,Bt),Pi=bt!=null&&Ut(bt,ae);Si&&Mn?(Xe==0?(En=Me,Fe=jt):(En=xe,Fe=Yt),nn=S[_t],ci=O(en(En,Bt),nn,tt,0),Jn=O(en(En+Fe,Bt),nn,tt,0),zo(Ui(ci,Jn),_n(Jn-ci))):zo(0,tt),Pi&&wn?(Xe==1?(En=Me,Fe=jt):(En=xe,Fe=Yt),nn=S[bt],ci=I(en(En,ae),nn,ht,0),Jn=I(en(En+Fe,ae),nn,ht,0),Vo(Ui(ci,Jn),_n(Jn-ci))):Vo(0,ht)}else Oh()}else{let _t=_n(of-sf),bt=_n(af-rf);if(P.ori==1){let ae=_t;_t=bt,bt=ae}Mn=Nn.x&&_t>=Nn.dist,wn=Nn.y&&bt>=Nn.dist;let Nt=Nn.uni;Nt!=null?Mn&&wn&&(Mn=_t>=Nt,wn=bt>=Nt,!Mn&&!wn&&(bt>_t?wn=!0:Mn=!0)):Nn.x&&Nn.y&&(Mn||wn)&&(Mn=wn=!0);let Ut,Bt;Mn&&(P.ori==0?(Ut=Nr,Bt=He):(Ut=Ur,Bt=$e),zo(Ui(Ut,Bt),_n(Bt-Ut)),wn||Vo(0,ht)),wn&&(P.ori==1?(Ut=Nr,Bt=He):(Ut=Ur,Bt=$e),Vo(Ui(Ut,Bt),_n(Bt-Ut)),Mn||zo(0,tt)),!Mn&&!wn&&(zo(0,0),Vo(0,0))}if(Nn._x=Mn,Nn._y=wn,x==null){if(N){if(yf!=null){let[_t,bt]=un.scales;un.values[0]=_t!=null?Yi(P.ori==0?He:$e,_t):null,un.values[1]=bt!=null?Yi(P.ori==1?He:$e,bt):null}Ho(jh,n,He,$e,k,Ct,U)}if(ee){let _t=N&&un.setSeries,bt=kt.prox;nr==null?ls<=bt&&qi(Ns,Or,!0,_t):ls>bt?qi(null,Or,!0,_t):Ns!=nr&&qi(Ns,Or,!0,_t)}}xt&&(nt.idx=U,Nh()),T!==!1&&Tn("setCursor")}let Us=null;Object.defineProperty(n,"rect",{get(){return Us==null&&Go(!1),Us}});function Go(x=!1){x?Us=null:(Us=p.getBoundingClientRect(),Tn("syncRect",Us))}function hf(x,T,N,U,X,tt,ht){lt._lock||Ls&&x!=null&&x.movementX==0&&x.movementY==0||(Uh(x,T,N,U,X,tt,ht,!1,x!=null),x!=null?ir(null,!0,!0):ir(T,!0,!1))}function Uh(x,T,N,U,X,tt,ht,_t,bt){if(Us==null&&Go(!1),te(x),x!=null)N=x.clientX-Us.left,U=x.clientY-Us.top;else{if(N<0||U<0){He=-10,$e=-10;return}let[Nt,Ut]=un.scales,Bt=T.cursor.sync,[ae,Te]=Bt.values,[Me,xe]=Bt.scales,[jt,Yt]=un.match,Xe=T.axes[0].side%2==1,en=P.ori==0?k:Ct,En=P.ori==1?k:Ct,Fe=Xe?tt:X,nn=Xe?X:tt,ci=Xe?U:N,Jn=Xe?N:U;if(Me!=null?N=jt(Nt,Me)?a(ae,S[Nt],en,0):-10:N=en*(ci/Fe),xe!=null?U=Yt(Ut,xe)?a(Te,S[Ut],En,0):-10:U=En*(Jn/nn),P.ori==1){let Si=N;N=U,U=Si}}bt&&(T==null||T.cursor.event.type==jh)&&((N<=1||N>=k-1)&&(N=ar(N,k)),(U<=1||U>=Ct-1)&&(U=ar(U,Ct))),_t?(sf=N,rf=U,[Nr,Ur]=lt.move(n,N,U)):(He=N,$e=U)}let Fh={width:0,height:0,left:0,top:0};function Oh(){$a(Fh,!1)}let uf,df,ff,pf;function mf(x,T,N,U,X,tt,ht){Ls=!0,Mn=wn=Nn._x=Nn._y=!1,Uh(x,T,N,U,X,tt,ht,!0,!1),x!=null&&(be(Qh,su,gf,!1),Ho(qf,n,Nr,Ur,k,Ct,null));let{left:_t,top:bt,width:Nt,height:Ut}=We;uf=_t,df=bt,ff=Nt,pf=Ut}function gf(x,T,N,U,X,tt,ht){Ls=Nn._x=Nn._y=!1,Uh(x,T,N,U,X,tt,ht,!1,!0);let{left:_t,top:bt,width:Nt,height:Ut}=We,Bt=Nt>0||Ut>0,ae=uf!=_t||df!=bt||ff!=Nt||pf!=Ut;if(Bt&&ae&&$a(We),Nn.setScale&&Bt&&ae){let Te=_t,Me=Nt,xe=bt,jt=Ut;if(P.ori==1&&(Te=bt,Me=Ut,xe=_t,jt=Nt),Mn&&Ds(M,Yi(Te,M),Yi(Te+Me,M)),wn)for(let Yt in S){let Xe=S[Yt];Yt!=M&&Xe.from==null&&Xe.min!=ke&&Ds(Yt,Yi(xe+jt,Yt),Yi(xe,Yt))}Oh()}else lt.lock&&(lt._lock=!lt._lock,ir(T,!0,x!=null));x!=null&&(pn(Qh,su),Ho(Qh,n,He,$e,k,Ct,null))}function h_(x,T,N,U,X,tt,ht){if(lt._lock)return;te(x);let _t=Ls;if(Ls){let bt=!0,Nt=!0,Ut=10,Bt,ae;P.ori==0?(Bt=Mn,ae=wn):(Bt=wn,ae=Mn),Bt&&ae&&(bt=He<=Ut||He>=k-Ut,Nt=$e<=Ut||$e>=Ct-Ut),Bt&&bt&&(He=He<Nr?0:k),ae&&Nt&&($e=$e<Ur?0:Ct),ir(null,!0,!0),Ls=!1}He=-10,$e=-10,G.fill(null),ir(null,!0,!0),_t&&(Ls=_t)}function _f(x,T,N,U,X,tt,ht){lt._lock||(te(x),ko(),Oh(),x!=null&&Ho(Zf,n,He,$e,k,Ct,null))}function xf(){R.forEach(Pv),B(n.width,n.height,!0)}hr(ll,Hr,xf);let Br={};Br.mousedown=mf,Br.mousemove=hf,Br.mouseup=gf,Br.dblclick=_f,Br.setSeries=(x,T,N,U)=>{let X=un.match[2];N=X(n,T,N),N!=-1&&qi(N,U,!0,!1)},ut&&(be(qf,p,mf),be(jh,p,hf),be(Yf,p,x=>{te(x),Go(!1)}),be($f,p,h_),be(Zf,p,_f),du.add(n),n.syncRect=Go);let Za=n.hooks=i.hooks||{};function Tn(x,T,N){Zn?Ne.push([x,T,N]):x in Za&&Za[x].forEach(U=>{U.call(null,n,T,N)})}(i.plugins||[]).forEach(x=>{for(let T in x.hooks)Za[T]=(Za[T]||[]).concat(x.hooks[T])});let vf=(x,T,N)=>N,un=dn({key:null,setSeries:!1,filters:{pub:op,sub:op},scales:[M,v[1]?v[1].scale:null],match:[ap,ap,vf],values:[null,null]},lt.sync);un.match.length==2&&un.match.push(vf),lt.sync=un;let yf=un.key,Bh=im(yf);function Ho(x,T,N,U,X,tt,ht){un.filters.pub(x,T,N,U,X,tt,ht)&&Bh.pub(x,T,N,U,X,tt,ht)}Bh.sub(n);function u_(x,T,N,U,X,tt,ht){un.filters.sub(x,T,N,U,X,tt,ht)&&Br[x](null,T,N,U,X,tt,ht)}n.pub=u_;function d_(){Bh.unsub(n),du.delete(n),bn.clear(),au(ll,Hr,xf),l.remove(),gt?.remove(),Tn("destroy")}n.destroy=d_;function kh(){Tn("init",i,t),Bo(t||i.data,!1),V[M]?Ih(M,V[M]):ko(),rt=We.show&&(We.width>0||We.height>0),it=xt=!0,B(i.width,i.height)}return v.forEach(Rr),R.forEach(ss),e?e instanceof HTMLElement?(e.appendChild(l),kh()):e(n,kh):kh(),n}Pn.assign=dn;Pn.fmtNum=vu;Pn.rangeNum=cl;Pn.rangeLog=dl;Pn.rangeAsinh=_u;Pn.orient=dr;Pn.pxRatio=Ee;Pn.join=Sx;Pn.fmtDate=Su,Pn.tzDate=Lx;Pn.sync=im;{Pn.addGap=pv,Pn.clipGaps=ml;let i=Pn.paths={points:cm};i.linear=um,i.stepped=_v,i.bars=xv,i.spline=yv}var Iv=[[],[8,4],[2,3]];function mm(i,t,e){return{label:i,labelSize:18,labelFont:"12px system-ui, sans-serif",font:"12px system-ui, sans-serif",stroke:t,grid:{stroke:e,width:1},ticks:{stroke:e,width:1},values:(n,s)=>s.map(Rn)}}var zn=class{constructor({x:t,y:e,series:n,alt:s,height:r=190}){this.options={x:t,y:e,series:n,height:r},this.element=q("div",{class:"plot",role:"img","aria-label":s}),this.data=[[],...n.map(()=>[])],this.plot=null,new ResizeObserver(()=>this.resize()).observe(this.element),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.restyle()),document.addEventListener("themechange",()=>this.restyle())}make(){let{x:t,y:e,series:n,height:s}=this.options,[r,o]=[Bn("ink"),Bn("line")],a=[1,2,3].map(c=>Bn(`series-${c}`));this.plot=new Pn({width:Math.max(120,this.element.clientWidth),height:s,legend:{show:n.length>1,live:!1},cursor:{show:!1},scales:{x:{time:!1,range:(c,l,h)=>this.reach(l,h)}},axes:[mm(t,r,o),{...mm(e,r,o),size:56}],series:[{},...n.map(({label:c,kind:l="line"},h)=>({label:c,stroke:a[h%3],width:2,dash:Iv[h%3],points:{show:!1},spanGaps:!1,...l==="bars"?{paths:Pn.paths.bars({size:[.9,60]}),fill:a[h%3],dash:[],width:0}:{}}))]},this.data,this.element)}reach(t,e){let[n]=this.data,r=this.options.series.some(({kind:o})=>o==="bars")&&n.length>1?(n[1]-n[0])/2:0;return e>t?[t-r,e+r]:[t-1,e+1]}resize(){this.element.clientWidth!==0&&(this.plot?this.plot.setSize({width:Math.max(120,this.element.clientWidth),height:this.options.height}):this.make())}restyle(){this.plot?.destroy(),this.plot=null,this.resize()}label(t){this.options.y!==t&&(this.options.y=t,this.plot&&this.restyle())}show(t){this.data=t,this.plot?.setData(t)}};function Kr(i,t){let e=null,n=q("input",{type:"number",min:0,step:1,"aria-label":"Shot number",onchange:()=>l(Number(n.value))}),s=q("button",{type:"button",onclick:()=>e===null?l(i.latestResult):h()},"Hold"),r=q("button",{type:"button","aria-label":"Shot before",onclick:()=>l(Math.max(0,(e??i.latestResult??0)-1))},"‹"),o=q("button",{type:"button","aria-label":"Shot after",onclick:()=>l((e??i.latestResult??0)+1)},"›"),a=q("span",{class:"hint"}),c=q("div",{class:"choice shot-choice"},q("span",{class:"label"},"Shot"),r,n,o,s,a);function l(u){u===null||!Number.isInteger(u)||u<0||(e=u,t(u),d())}function h(){e=null,t(null),d()}function d(){let u=e??i.latestResult;document.activeElement!==n&&(n.value=u??""),$t(s,e===null?"Hold":"Follow"),s.setAttribute("aria-pressed",String(e!==null)),$t(a,e===null?"the latest":"held")}return{element:c,update:d,get held(){return e}}}var Lv=40,vl=class{constructor(t,{changed:e=()=>{},overlay:n=null}={}){this.canvas=q("canvas",{class:"zoom",tabindex:"0",role:"img","aria-label":`${t}; plus and minus magnify, arrow keys move`}),this.changed=e,this.overlay=n,this.bitmap=null,this.size=[1,1],this.zoom=1,this.brightness=1,this.middle=[.5,.5],this.pointers=new Map,this.canvas.addEventListener("wheel",s=>{s.preventDefault(),this.magnify(Math.exp(-s.deltaY/300),this.under(s))},{passive:!1}),this.canvas.addEventListener("pointerdown",s=>{this.canvas.setPointerCapture(s.pointerId),this.pointers.set(s.pointerId,[s.clientX,s.clientY])}),this.canvas.addEventListener("pointermove",s=>this.drag(s));for(let s of["pointerup","pointercancel"])this.canvas.addEventListener(s,r=>this.pointers.delete(r.pointerId));this.canvas.addEventListener("dblclick",s=>this.magnify(2,this.under(s))),this.canvas.addEventListener("keydown",s=>this.key(s)),new ResizeObserver(()=>this.draw()).observe(this.canvas)}key(t){let e=.15/this.zoom,n={ArrowLeft:[-e,0],ArrowRight:[e,0],ArrowUp:[0,-e],ArrowDown:[0,e]},s={"+":1.4,"=":1.4,"-":1/1.4,0:1/this.zoom};if(n[t.key])this.move(...n[t.key]);else if(s[t.key])this.magnify(s[t.key],this.middle);else return;t.preventDefault()}drag(t){let e=this.pointers.get(t.pointerId);if(!e)return;let n=[t.clientX,t.clientY],s=[...this.pointers].filter(([o])=>o!==t.pointerId).map(([,o])=>o);if(this.pointers.set(t.pointerId,n),s.length===1){let o=a=>Math.hypot(a[0]-s[0][0],a[1]-s[0][1]);this.magnify(o(n)/Math.max(1,o(e)),this.middle);return}let r=this.scale();this.move(-(n[0]-e[0])/(r*this.size[0]),-(n[1]-e[1])/(r*this.size[1]))}move(t,e){this.middle=[this.middle[0]+t,this.middle[1]+e],this.settle()}magnify(t,e){let n=Math.min(Lv,Math.max(1,this.zoom*t)),s=this.zoom/n;this.middle=this.middle.map((r,o)=>e[o]+(r-e[o])*s),this.zoom=n,this.settle()}settle(){this.middle=this.middle.map(t=>Math.min(1-.5/this.zoom,Math.max(.5/this.zoom,t))),this.draw(),this.changed()}scale(){let{clientWidth:t,clientHeight:e}=this.canvas;return this.zoom*Math.min(t/this.size[0],e/this.size[1])}under(t){let e=this.canvas.getBoundingClientRect(),n=this.scale();return[this.middle[0]+(t.clientX-e.left-e.width/2)/(n*this.size[0]),this.middle[1]+(t.clientY-e.top-e.height/2)/(n*this.size[1])]}show(t,e){this.bitmap?.close(),this.bitmap=t,this.size=e,this.draw()}draw(){let{width:t,height:e,ratio:n}=Os(this.canvas),s=this.canvas.getContext("2d");if(s.setTransform(1,0,0,1,0,0),s.fillStyle=Bn("image-ground"),s.fillRect(0,0,t,e),!this.bitmap)return;let r=this.scale()*n,[o,a]=[t/2-this.middle[0]*this.size[0]*r,e/2-this.middle[1]*this.size[1]*r],c=r*this.size[0]/this.bitmap.width;s.imageSmoothingEnabled=c<3*n,s.filter=this.brightness===1?"none":`brightness(${this.brightness})`,s.drawImage(this.bitmap,o,a,this.size[0]*r,this.size[1]*r),s.filter="none";let l=(h,d)=>[o+(h+.5)*r,a+(d+.5)*r];this.overlay?.(s,{place:l,scale:r,ratio:n,width:t,height:e})}};var Dv=2e3,[Nv,Uv]=[900,8192],Fv=2.5,gm=1.25,Ov=.15,Bv=.9,kv=5;function _m(i){let t=q("div",{class:"view cameras-view"}),e={frame:"a",held:null},n=Kr(i,f=>{e.held=f,u(!0)}),s=ii("Frame",{a:"a",b:"b"},f=>{e.frame=f,u(!0)}),r=Fs("Configured micro-images",!0,()=>c.forEach(f=>f.draw())),o=or("Brightness",{max:4,value:0},f=>{$t(o.shown,`× ${2**f}`),c.forEach(p=>p.brighten(2**f))});$t(o.shown,"× 1");let a=q("div",{class:"two"}),c=[];t.append(q("div",{class:"controls"},n.element,s.element,o.element,r.element),a);let l=-1/0,h=!1;function d(){return i.status?.configuration.cameras??[]}async function u(f=!1){if(!(t.hidden||!t.isConnected||h||document.hidden)){for(;c.length<d().length;)c.push(zv(d()[c.length],c.length+1,i,e,r.input)),a.append(c.at(-1).element);!f&&(performance.now()-l<Dv||e.held!==null)||(l=performance.now(),h=!0,await Promise.all(c.map(p=>p.load())),h=!1)}}return{element:t,update(){n.update(),u()},show:()=>u(!0)}}function zv(i,t,e,n,s){let r=()=>c.zoom>Fv,o={shot:null,frame:null,near:!1},a=null,c=new vl(`Image of ${i}`,{changed:()=>r()!==o.near&&y(),overlay:(g,v)=>s.checked&&a&&Gv(g,v,a)}),l=q("p",{class:"empty"}),h=q("canvas",{class:"micro-image",role:"img","aria-label":"Mean micro-image"}),d={light:Gt("Light a, b",{title:"mean light above black, in counts"}),ratio:Gt("Light a over b"),saturated:Gt("Saturated a, b"),bright:Gt("Lit by particles",{title:"share of the pixels that hold a particle's light"}),seeding:Gt("Seeding a, b",{title:"particles per microlens of the volume"}),black:Gt("Black, noise"),diameter:Gt("Micro-images fill"),fNumber:Gt("f-number",{title:"of the main lens, as the micro-images show it"}),edge:Gt("Edge",{title:"distance over which light falls from 80 % to 20 %"})},u=q("ul",{class:"causes"}),f=new zn({x:"counts",y:"log10 pixels",height:150,alt:`Histogram of ${i}`,series:[{label:"frame a"},{label:"frame b"}]}),p=Be(i,l,c.canvas,q("dl",{class:"readings"},...Object.values(d).map(g=>g.element)),q("div",{class:"beside"},q("figure",{},h,q("figcaption",{},"Mean micro-image")),q("div",{},u)),f.element);async function y(){let g=`/api/v1/shots/${n.held??"latest"}/frames/${t}`,v=r()?Uv:Nv;try{let[{bitmap:R},S]=await Promise.all([Ka(`${g}/${n.frame}.png?width=${v}`),Li(`${g}/statistics`)]);o={shot:S.shot,frame:n.frame,near:r()},a=S.configured;let[C,M]=a.sensor_px;c.show(R,[C,M]),$t(l,""),m(S)}catch(R){$t(l,R instanceof on?R.message:"the daemon does not answer")}}function m(g){let[v,R]=g.frames,S=I=>`${I(v)}, ${I(R)}`;d.light.show(S(I=>Ht(I.light_counts)));let C=g.a_over_b,M=C!==null&&(C>gm||C<1/gm);d.ratio.show(Ht(C,2),M?"doubt":null);let _=Math.max(v.saturated_share,R.saturated_share);d.saturated.show(S(I=>Cn(I.saturated_share,2)),_>.001?"doubt":null),d.bright.show(S(I=>Cn(I.bright_share))),d.seeding.show(S(I=>Ht(I.seeding_ppm,2))),d.black.show(`${Ht(v.offset_counts)}, ${Ht(v.noise_counts,2)}`);let b=v.micro_image;d.diameter.show(b?Cn(b.diameter_pitches):"–"),d.fNumber.show(b?`f/${Ht(b.f_number,2)} (configured f/${Ht(a.f_number,2)})`:"–"),d.edge.show(b?.edge_px?`${Ht(b.edge_px,2)} px`:"–");let F=Vv(g,{unequal:M,saturated:_});u.replaceChildren(...F.map(([I,V])=>q("li",{"data-tone":I},V))),Hv(h,b);let A=Math.max(v.histogram.length,R.histogram.length),P=Math.max(v.bin_counts,R.bin_counts),D=Array.from({length:A},(I,V)=>(V+.5)*P),O=I=>{let V=new Array(A).fill(0);return I.histogram.forEach((H,z)=>{V[Math.min(A-1,Math.floor((z+.5)*I.bin_counts/P))]+=H}),V.map(H=>H>0?Math.log10(H):null)};f.show([D,O(v),O(R)])}return{element:p,load:y,draw:()=>c.draw(),brighten(g){c.brightness=g,c.draw()}}}function Vv({configured:i,frames:t,a_over_b:e},{unequal:n,saturated:s}){let r=[];n&&r.push(["doubt",`Frame a has ${Ht(e,2)} times the light of frame b: set the laser heads alike.`]),s>.001&&r.push(["doubt",`${Cn(s,1)} of the pixels are saturated: less laser light, or a lower gain.`]);let o=t[0].micro_image;if(!o)return r.push(["doubt","Micro-images do not stand out: too little light, main lens opened too far, or the array is out of focus."]),r;let a=o.diameter_pitches&&o.diameter_pitches/(i.diameter_px/i.pitch_px);return o.corner_share>Ov||a===null?r.push(["doubt",`Micro-images overlap: their corners have ${Cn(o.corner_share)} of the light. Stop the main lens down towards f/${Ht(i.f_number,2)}.`]):a<Bv?r.push(["doubt",`Micro-images fill only ${Cn(a)} of their diameter: open the main lens from f/${Ht(o.f_number,2)} to f/${Ht(i.f_number,2)}.`]):r.push(["good","Micro-images fill their pitch and do not overlap: the f-numbers match."]),o.edge_px!==null&&r.push(o.edge_px>kv?["doubt",`Their edges are ${Ht(o.edge_px,2)} px wide: move the sensor into the microlenses' focal plane.`]:["good",`Their edges are ${Ht(o.edge_px,2)} px wide: the array is in focus.`]),r}function Gv(i,{place:t,scale:e,ratio:n,width:s,height:r},{pitch_px:o,diameter_px:a,middle_px:c}){if(o*e<14*n)return;let[l,h]=t(...c),d=o*e;i.strokeStyle="#ffb000",i.lineWidth=1.2*n,i.beginPath();for(let u=l%d-d;u<s+d;u+=d)for(let f=h%d-d;f<r+d;f+=d)i.moveTo(u+a*e/2,f),i.arc(u,f,a*e/2,0,2*Math.PI);i.stroke()}function Hv(i,t){let e=t?.cells??1;[i.width,i.height]=[e,e];let n=i.getContext("2d"),s=n.createImageData(e,e),r=Math.max(1,...t?.light??[]);for(let o=0;o<e*e;o+=1){let a=Math.max(0,Math.round(255*(t?.light[o]??0)/r));s.data.set([a,a,a,255],4*o)}n.putImageData(s,0,0)}function zs(i){let t=q("thead"),e=q("tbody"),n=q("caption",{},i),s=q("div",{class:"table",...cs(i)},q("table",{},n,t,e));function r(o,a,c,l){let h=o.children[a]??o.appendChild(q("tr"));for(;h.childElementCount<l.length;)h.append(q(c,c==="th"?{scope:"col"}:{}));for(;h.childElementCount>l.length;)h.lastChild.remove();l.forEach((d,u)=>{$t(h.children[u],d.text??d),An(h.children[u],"data-tone",d.tone??null)})}return{element:s,show(o,a,c=""){for(r(t,0,"th",o),a.forEach((l,h)=>r(e,h,"td",l));e.childElementCount>a.length;)e.lastChild.remove();$t(n,c||i)}}}var xm={measuring:"good",idle:null,lost:"bad",ended:null},Ru=40,Wv=2;function vm(i){let t={backlog:Gt("To be measured"),inHand:Gt("Being measured"),waiting:Gt("Waiting"),rate:Gt("All workers",{title:"results over the last minute"}),left:Gt("Work left",{title:"shots to be measured, over the present rate"}),begun:Gt("Begun",{title:"measurements that workers have begun"}),notEnded:Gt("Not ended",{title:"measurements whose worker was lost: their shots went to others"}),givenUp:Gt("Given up",{title:"after three failures or ten lost workers"}),refused:Gt("Results refused",{title:"damaged, or not of this run"})},e=q("p",{class:"advice"}),n=zs("What each has done for this run"),s=q("p",{class:"hint"}),r=zs("Shots that were given up"),o=new zn({x:"minutes from now",y:"shots",height:150,alt:"Shots to be measured and being measured, over the last minutes",series:[{label:"to be measured"},{label:"being measured"}]}),a=Be("Workers",q("dl",{class:"readings"},...Object.values(t).map(l=>l.element)),e,n.element,s,q("div",{class:"two"},r.element,o.element));return a.classList.add("workers"),a.hidden=!0,{element:a,show(l){if(a.hidden=!l,!l)return;let{shots:h,workers:d}=l;t.backlog.show(le(h.backlog)),t.inHand.show(le(h.in_hand)),t.waiting.show(le(Math.max(0,h.backlog-h.in_hand))),t.rate.show(`${Ht(60*l.shots_per_s)} shots/min`),t.left.show(h.backlog===0?"none":l.shots_per_s>0?hs(h.backlog/l.shots_per_s):"–"),t.begun.show(le(h.attempts)),t.notEnded.show(le(h.lost_workers),h.lost_workers>0?"doubt":null),t.givenUp.show(le(h.given_up),h.given_up>0?"bad":null),t.refused.show(le(h.refused_results),h.refused_results>0?"bad":null);let[u,f]=qv(l);$t(e,f),An(e,"data-tone",u),c(d),r.element.hidden=l.given_up.length===0,r.show(["Shot","why"],l.given_up.map(({shot:y,reasons:m})=>[String(y),Xv(m)]),l.given_up.length<h.given_up?`The first ${l.given_up.length} of ${le(h.given_up)} shots that were given up`:"");let p=i.backlog.at(-1)?.at??0;o.show([i.backlog.map(({at:y})=>(y-p)/6e4),i.backlog.map(y=>y.backlog),i.backlog.map(y=>y.inHand)])}};function c(l){let h=Object.keys(xm),d=[...l].sort((u,f)=>h.indexOf(u.state)-h.indexOf(f.state));n.element.hidden=l.length===0,n.show(["Worker","state","last heard of","delivered","shots/min","in hand","begun","failed","not ended"],d.slice(0,Ru).map(u=>[u.worker,{text:u.state,tone:xm[u.state]},u.silent_s<Wv?"now":`${hs(u.silent_s)} ago`,le(u.shots),Ht(60*u.shots_per_s),le(u.in_hand),le(u.attempts),{text:le(u.failures),tone:u.failures>0?"doubt":null},{text:le(u.not_ended),tone:u.not_ended>0?"doubt":null}])),s.hidden=l.length<=Ru,$t(s,`and ${le(l.length-Ru)} more: GET /api/v1/status lists all of them`)}}function Xv(i){let t=new Map;for(let e of i)t.set(e,(t.get(e)??0)+1);return[...t].map(([e,n])=>n>1?`${e} (${n} times)`:e).join("; ")}function qv({broker:i,connected:t,heartbeat_timeout_s:e,shots:n,workers:s}){if(!t)return["doubt",`The broker at ${i} does not answer. Shots are recorded, and wait until it does.`];let r=(...l)=>s.filter(({state:h})=>l.includes(h)).length,o=r("measuring","idle");if(o===0&&n.backlog>0)return["doubt",s.length===0?`No worker has taken a shot yet. On each machine that is to measure: lfpiv work --url ${i}`:"No worker is left: all are lost or have ended. Shots are recorded, and wait for others."];let a=r("lost"),c=a>0?` ${le(a)} ${a===1?"was":"were"} not heard of for more than ${hs(e)}: what ${a===1?"it":"they"} had in hand goes to others.`:"";return[null,`Measuring: ${le(r("measuring"))} of ${le(o)}. The broker at ${i} answers.${c}`]}var Yv=["complete","missing_packets","underrun","missed_trigger","late","unpaired","shed","write_failed","not_fired"],ym=["acquired","paired","written","fsynced","processed"],$v=14,Sm=60,Zv=200;function bm(i){let t={run:Gt("Run"),stage:Gt("Now",{wide:!0}),dt:Gt("dt"),rate:Gt("Measured"),asked:Gt("Asked for"),queue:Gt("Queue"),latency:Gt("Latency",{title:"from trigger to stored velocity: median, 95th percentile"}),disk:Gt("Disk left"),uptime:Gt("Up for")},e={verdict:Gt("Model fit"),unexplained:Gt("Light unexplained",{title:"per camera; 0: everything is explained"}),offset:Gt("Micro-images off",{title:"largest distance from the configured place, per camera"}),disparity:Gt("Cameras apart",{title:"root mean square distance between the places at which they put particles"}),calibration:Gt("Calibration"),seeding:Gt("Seeding")},n=q("ul",{class:"causes"}),s=zs("Calibrated cameras: the file and its SHA-256");s.element.classList.add("hashes");let r=zs("Triggers by camera and outcome"),o=zs("How many shots have got how far"),a=zs("Latest shots, newest first"),c=q("p",{class:"hint"}),l=q("p",{class:"hint"},"Nothing yet that is worth a line."),h=q("ol"),d=vm(i),u=new zn({x:"shot",y:"seconds",alt:"Time that the last shots took to measure",height:150,series:[{label:"time to measure"}]}),f=q("div",{class:"view overview"},q("dl",{class:"readings"},...Object.values(t).map(M=>M.element)),d.element,q("div",{class:"two"},q("div",{},Be("Shots",c,a.element),Be("Model fit",q("dl",{class:"readings"},...Object.values(e).map(M=>M.element)),n,s.element)),q("div",{},Be("What happened",l,q("div",{class:"log",...cs("What happened")},h)),Be("Ledger",r.element,o.element),Be("Time to measure a shot",u.element))));function p(){let{status:M}=i,_=i.brief??M;if(!_)return;let b=_.state;if(t.run.show(Lf(b),{failed:"bad",bench_lost:"bad"}[b]??null),t.stage.show(_.error??_.stage,_.error?"bad":null),t.rate.show(`${Ht(i.rate,2)} shots/s`),R(_.shots),C(),!M)return;let{configuration:F,latency:A,disk:P}=M;t.dt.show(`${Ht(i.control?.dt_us??F.dt_us)} µs`),t.asked.show(`${Ht(F.rate_hz)} Hz${F.shots?`, ${le(F.shots)} shots`:""}`),t.queue.element.hidden=!!M.cluster,t.queue.show(`${_.shots.queued} of ${F.queue}`,_.shots.queued>=F.queue?"doubt":null),t.latency.show(A?`${hs(A.p50_s)}, ${hs(A.p95_s)}`:"–"),y(P),t.uptime.show(hs(M.uptime_s)),d.show(M.cluster),m(M),v(M)}function y(M){if(!M){t.disk.show("–");return}let _=M.shots_left;t.disk.show(`${Pf(M.free_bytes)}${_===null?"":`, ${le(_)} shots`}`,_!==null&&_<600?"doubt":null)}function m(M){let _=M.model_fit,b=P=>_?.cameras.map(P).join(", ")??"–";e.verdict.show(_?.verdict??"–",{good:"good",doubtful:"doubt",poor:"bad"}[_?.verdict]??null),e.unexplained.show(b(P=>Cn(P.unexplained))),e.offset.show(_?`${b(P=>Ht(P.micro_image_offset_px,2))} px`:"–"),e.disparity.show(_?.camera_disparity_mm?`${Ht(_.camera_disparity_mm,2)} mm`:"–"),g(M.configuration);let F=M.model_choice?.scene;e.seeding.element.hidden=!F,e.seeding.show(F?`${Ht(F.seeding_ppm,2)} per microlens`:"–");let A=_?.causes??[];(n.childElementCount!==A.length||[...n.children].some((P,D)=>P.textContent!==A[D]))&&n.replaceChildren(...A.map(P=>q("li",{},P)))}function g({cameras:M,calibrations:_}){e.calibration.show(_.length===0?"as configured":`${_.length} of ${M.length} cameras`),s.element.hidden=_.length===0,s.show(["Camera","file","SHA-256"],_.map(({camera:b,file:F,sha256:A})=>[b,F,A]))}function v(M){let{cameras:_,balanced:b}=M.ledger,F=Yv.filter((P,D)=>D===0||_.some(O=>O.outcomes[P]>0));r.show(["Camera","triggers","open",...F.map(Hh)],_.map(P=>[P.camera,le(P.triggers),le(P.open),...F.map(D=>le(P.outcomes[D]))]),b?"":"The ledger does not balance.");let A=i.brief?.watermarks??M.watermarks;o.show(A?ym:["Raw data"],[A?ym.map(P=>le(A[P])):["not kept"]])}function R(M){let _=A=>["awaiting_frames","queued"].includes(A.state),b=i.latestShots(Zv).filter(A=>!_(A)).slice(0,$v);$t(c,`${le(M.triggered)} triggered, ${le(M.done)} measured; ${le(M.awaiting_frames)} wait for frames, ${le(M.queued)} for a worker`),a.show(["Shot","time","state","model fit","valid","took"],b.map(A=>[String(A.shot),If(A.time?.utc),Jv(A),A.model_fit?.verdict??"–",Cn(A.valid_share),A.seconds?hs(Object.values(A.seconds).reduce((P,D)=>P+D,0)):"–"]));let F=i.latestShots(120).filter(A=>A.seconds).reverse();u.show([F.map(A=>A.shot),F.map(A=>Object.values(A.seconds).reduce((P,D)=>P+D,0))])}let S=null;function C(){l.hidden=i.log.length>0;let M=i.log.at(-1)??null;if(M===S&&h.childElementCount===Math.min(Sm,i.log.length))return;S=M;let _=i.log.slice(-Sm).reverse();for(;h.childElementCount<_.length;)h.append(q("li",{},q("time",{}),q("span",{})));for(;h.childElementCount>_.length;)h.lastChild.remove();_.forEach((b,F)=>{let A=h.children[F];$t(A.firstChild,b.at?b.at.toLocaleTimeString("en-GB"):"before"),$t(A.lastChild,b.text),An(A,"data-tone",b.tone)})}return{element:f,update:p,show:p}}function Jv(i){let t=(i.cameras??[]).filter(n=>n.outcome&&n.outcome!=="complete"),e=i.message??i.suspect?.[0]??(i.state==="lost"?t.map(n=>`${n.camera} ${Hh(n.outcome)}`).join(", "):null);return e?`${Xo(i.state)}: ${e}`:Xo(i.state)}var Kv="http://www.w3.org/2000/svg",[ta,yl,Cu,Pu]=[120,860,34,10];function Vs(i,t,...e){let n=document.createElementNS(Kv,i);for(let[s,r]of Object.entries(t))n.setAttribute(s,String(r));return n.append(...e),n}function Mm(){let i=q("div",{class:"timing",...cs("Timing")}),t=null;function e(){if(!t)return;let n=p=>[p,p+t.pulse_width_us,Rn(p)],s=[["Lamps 1, 2",t.lamp_us.map(n),"lamp-pulse"],["Q-switches 1, 2",t.q_switch_us.map(n),"light-pulse"],["Camera trigger",[n(t.camera_trigger_us)],"trigger-pulse"],["Exposures a, b",[[...t.exposure_1_us,"a"],[...t.exposure_2_us,"b"]],"exposure"]],r=Math.max(...t.q_switch_us,...t.lamp_us)+2*t.pulse_width_us+40,o=Math.max(r,t.exposure_2_us[0]+.3*(t.exposure_1_us[1]-t.exposure_1_us[0])),a=p=>ta+yl*Math.min(p,o)/o,c=Pu+Cu*s.length+46,l=Vs("svg",{viewBox:`0 0 ${ta+yl+16} ${c}`,role:"img","aria-label":jv(t)});s.forEach(([p,y,m],g)=>{let v=Pu+Cu*(g+1)-6;l.append(Vs("text",{x:0,y:v-6,class:"name"},p)),l.append(Vs("line",{x1:ta,x2:ta+yl,y1:v,y2:v,class:"base"}));for(let[R,S,C]of y){let M=Math.max(2.5,a(S)-a(R));l.append(Vs("rect",{x:a(R),y:v-20,width:M,height:20,class:m}));let _=m==="exposure"?a(R)+8:a(R)+M+4;l.append(Vs("text",{x:_,y:v-6,class:"at"},C))}});let h=Pu+Cu*s.length+8,d=Qv(o);for(let p=0;p<=o;p+=d)l.append(Vs("line",{x1:a(p),x2:a(p),y1:h,y2:h+5,class:"base"})),l.append(Vs("text",{x:a(p),y:h+20,class:"tick"},Rn(p)));l.append(Vs("text",{x:ta+yl/2,y:h+36,class:"tick"},"µs after T0"));let[u,f]=t.q_switch_us;i.replaceChildren(l,q("p",{class:"hint"},`Light pulses at ${Rn(u)} and ${Rn(f)} µs, ${Rn(t.dt_us)} µs apart; cameras ready again after ${Ht(t.camera_ready_us/1e3)} ms of a period of ${Ht(t.period_us/1e3)} ms.`))}return{element:i,draw:e,show(n){t=n,e()}}}function jv({q_switch_us:[i,t],exposure_1_us:e,exposure_2_us:n}){return`Timing diagram: light pulse 1 at ${Ht(i,4)} µs in exposure a from ${Ht(e[0],4)} to ${Ht(e[1],4)} µs; light pulse 2 at ${Ht(t,4)} µs in exposure b from ${Ht(n[0],4)} µs`}function Qv(i){let t=10**Math.floor(Math.log10(i/8));return[1,2,5,10].map(e=>e*t).find(e=>e>=i/8)}var ty=4096;function Tm(i,t){let e=Gt("Laser",{wide:!0}),n=Gt("Why nothing is fired",{wide:!0}),s={configuration:Gt("Configuration allows arming",{title:"server.remote_arming"}),operator:Gt("Operator has enabled it at the bench",{title:"lfpiv run --remote-arming"})},r=q("button",{type:"button",onclick:()=>l.showModal()},"Arm …"),o=q("button",{type:"button",onclick:()=>t.send("start")},"Start"),a=q("input",{type:"checkbox",id:"goggles",onchange:()=>{c.disabled=!a.checked}}),c=q("button",{type:"submit",class:"primary",disabled:!0},"Arm the laser"),l=q("dialog",{"aria-labelledby":"arm-title"},q("form",{onsubmit:H=>M(H)},q("h2",{id:"arm-title"},"Arm the laser?"),q("p",{},"The lamps begin to fire. After start, light pulses leave the laser. This page is no interlock."),q("div",{class:"choice"},a,q("label",{for:"goggles"},"The room is clear and everybody in it wears goggles")),q("div",{class:"row"},c,q("button",{type:"button",onclick:()=>l.close()},"Cancel"))));l.addEventListener("close",()=>{a.checked=!1,c.disabled=!0});let h=q("p",{class:"hint"}),d=q("input",{type:"number",id:"dt",min:.1,max:1e6,step:"any",oninput:()=>P()}),u=q("button",{type:"submit"},"Set dt"),f=q("form",{class:"controls",onsubmit:H=>_(H)},q("label",{for:"dt"},"Time between the pulses (µs)"),d,u),p=Mm(),y=q("p",{class:"advice","data-tone":"doubt"}),m=q("textarea",{id:"note",rows:3,maxlength:ty}),g=q("form",{onsubmit:H=>b(H)},q("label",{for:"note"},"Words for the run's record"),m,q("div",{class:"row"},q("button",{type:"submit"},"Add the note"))),v=q("ol"),R=q("p",{class:"hint"}),S=q("pre",{class:"settings",...cs("Configuration")}),C=q("div",{class:"view run"},q("div",{class:"two"},Be("Controls",q("dl",{class:"readings"},e.element,n.element,...Object.values(s).map(H=>H.element)),q("div",{class:"controls large"},r,o),h),Be("Notes",g,q("div",{class:"log",...cs("Notes")},v))),Be("Timing",f,y,p.element),Be("Settings",R,S),l);async function M(H){H.preventDefault(),a.checked&&(l.close(),await t.send("arm"))}async function _(H){H.preventDefault(),await t.send("dt",{dt_us:Number(d.value)})&&(F=!1)}async function b(H){H.preventDefault(),m.value.trim()&&await t.send("note",{text:m.value.trim()})&&(m.value="")}let F=!1,A=null;function P(){F=!0,D(Number(d.value))}async function D(H){if(!(!(H>0)||A===H)){A=H;try{let z=await Li(`/api/v1/control/timing?dt_us=${encodeURIComponent(H)}`);if(A!==H)return;$t(y,""),p.show(z)}catch(z){if(A!==H)return;$t(y,z instanceof on?z.message:"the daemon does not answer"),z instanceof on||(A=null)}}}let O=null;async function I(){if(!(O===i.run&&S.textContent))try{let{file:H,text:z}=await Li("/api/v1/configuration");O=i.run,$t(R,H),$t(S,z)}catch(H){$t(R,H instanceof on?H.message:"the daemon does not answer")}}function V(){let H=tl(i);e.show(`${H.word} (${H.detail})`,H.tone==="firing"||H.tone==="unknown"?"bad":null),n.show(i.control?.held?.join("; ")||"–",i.control?.held?.length?"doubt":null);let z=i.permissions;s.configuration.show(z?wm(z.allowed_by_configuration):"–"),s.operator.show(z?wm(z.enabled_at_bench):"–");let ot=!!z?.controllable;r.disabled=o.disabled=!z?.may_arm||i.stale,u.disabled=d.disabled=!ot,g.hidden=!ot,$t(h,ot?z.may_arm?"Arm warms the lamps, start takes shots. Both need a token of scope control; stop and disarm are on top of every view.":"Arming over HTTP needs both permissions. Stop and disarm need a token of scope control only.":"A recorded run cannot be controlled.");let Y=i.control?.dt_us??i.status?.configuration.dt_us;!F&&Y&&document.activeElement!==d&&(d.value=String(Y),D(Y));let J=i.log.filter(G=>G.tone==="note").slice(-30).reverse();for(;v.childElementCount<J.length;)v.append(q("li",{},q("time",{}),q("span",{})));for(;v.childElementCount>J.length;)v.lastChild.remove();J.forEach((G,nt)=>{$t(v.children[nt].firstChild,G.at?G.at.toLocaleTimeString("en-GB"):"before"),$t(v.children[nt].lastChild,G.text.replace(/^Note: /,"")),An(v.children[nt],"data-tone","note")}),C.hidden||I()}return{element:C,update:V,show(){V(),p.draw()}}}var wm=i=>i?"yes":"no";function fr(){let i=q("canvas",{class:"colours","aria-hidden":"true"}),[t,e,n]=[q("span"),q("span"),q("span")],s=q("span",{class:"title"}),r=q("div",{class:"colour-bar"},s,i,q("div",{class:"ends"},t,e,n)),o=null;return{element:r,show(a,c,l=Ht){$t(s,c),$t(t,l(a.low)),$t(e,l((a.low+a.high)/2)),$t(n,l(a.high)),o!==a.colours&&a.paint(i),o=a.colours}}}var ey=["#00224e","#123570","#3b496c","#575d6d","#707173","#8a8678","#a59c74","#c3b369","#e1cc55","#fee838"],ny=["#9c179e","#bd3786","#d8576b","#ed7953","#fb9f3a","#fdca26","#f0f921"],iy=["#001261","#033e7d","#1e6f9d","#71a8c4","#c9dde7","#eacebd","#d39774","#be6533","#8b2706","#590007"],sy=i=>[1,3,5].map(t=>parseInt(i.slice(t,t+2),16));function Iu(i){let t=new Uint8Array(768),e=i.map(sy);for(let n=0;n<256;n+=1){let s=n/255*(e.length-1),r=Math.min(e.length-2,Math.floor(s));for(let o=0;o<3;o+=1)t[3*n+o]=Math.round(e[r][o]+(s-r)*(e[r+1][o]-e[r][o]))}return t}var ry=Iu(ey),oy=Iu(iy),Em=Iu(ny),fs=class{constructor(t,e,n=!1,s=n?oy:ry){this.low=t,this.high=e>t?e:t+1e-9,this.signed=n,this.colours=s}rgb(t){let e=Math.min(1,Math.max(0,(t-this.low)/(this.high-this.low))),n=3*Math.round(255*e);return[this.colours[n],this.colours[n+1],this.colours[n+2]]}paint(t){t.width=256,t.height=1;let e=t.getContext("2d"),n=e.createImageData(256,1);for(let s=0;s<256;s+=1)n.data.set([this.colours[3*s],this.colours[3*s+1],this.colours[3*s+2],255],4*s);e.putImageData(n,0,0)}};var Ti=[[1,2],[0,2],[0,1]];function Sl(i,t,e,n){let[s,r]=Ti[e],o=[];for(let a=0;a<i.n[r];a+=1){let c=[];for(let l=0;l<i.n[s];l+=1){let h=[0,0,0];[h[e],h[s],h[r]]=[n,l,a],c.push(t[kr(i,...h)])}o.push(c)}return o}function Lu(i,t){let e=i[0].length,n=new Uint8Array(4*e*i.length);return i.flat().forEach((s,r)=>{s===s&&n.set([...t.rgb(s),255],4*r)}),n}var ly=.5,jr=class{constructor(t){this.canvas=q("canvas",{class:"slice",role:"img","aria-label":"Slice through the field"}),this.buffer=document.createElement("canvas"),this.drawn=null;let e=()=>this.drawn&&this.draw(...this.drawn);new ResizeObserver(e).observe(this.canvas),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",e),document.addEventListener("themechange",e),this.canvas.addEventListener("pointerdown",n=>{if(!this.area)return;let s=this.canvas.getBoundingClientRect(),[r,o,a,c]=this.area,l=(n.clientX-s.left-r)/a,h=1-(n.clientY-s.top-o)/c;l>=0&&l<=1&&h>=0&&h<=1&&t(l,h)})}draw(t,e,n,s){this.drawn=[t,e,n,s];let{axis:r,index:o,scale:a,longest:c,line:l}=s,{width:h,height:d,ratio:u}=Os(this.canvas),f=this.canvas.getContext("2d");if(f.setTransform(1,0,0,1,0,0),f.clearRect(0,0,h,d),h<20)return;let[p,y]=Ti[r],[m,g]=[t.n[p],t.n[y]],[v,R]=[44*u,34*u],S=Math.min((h-v-8*u)/m,(d-R-8*u)/g),[C,M]=[S*m,S*g],[_,b]=[v+(h-v-8*u-C)/2,8*u+(d-R-8*u-M)/2];this.area=[_,b,C,M].map(A=>A/u),this.contour(f,Sl(t,e,r,o),a,[_,b,C,M]),this.body(f,Sl(t,t.status,r,o),[_,b+M,S]);let F=Bn("ink");if(f.strokeStyle=F,f.lineWidth=u,f.strokeRect(_,b,C,M),this.arrows(f,t,n,{axis:r,index:o,cell:S,x0:_,y0:b+M,longest:c,ratio:u}),l){let A=(l.index+.5)*S;f.setLineDash([6*u,4*u]),f.lineWidth=2*u,f.strokeStyle=F,f.beginPath(),l.along===0?(f.moveTo(_,b+M-A),f.lineTo(_+C,b+M-A)):(f.moveTo(_+A,b),f.lineTo(_+A,b+M)),f.stroke(),f.setLineDash([])}this.axes(f,t,{axis:r,ratio:u,x0:_,y0:b,w:C,hgt:M,ink:F})}contour(t,e,n,[s,r,o,a]){let c=e[0].length;[this.buffer.width,this.buffer.height]=[c,e.length];let l=Lu([...e].reverse(),n),h=new ImageData(new Uint8ClampedArray(l),c,e.length);this.buffer.getContext("2d").putImageData(h,0,0),t.imageSmoothingEnabled=!1,t.drawImage(this.buffer,s,r,o,a)}body(t,e,[n,s,r]){t.globalAlpha=ly,t.fillStyle=Bn("mask"),e.forEach((o,a)=>o.forEach((c,l)=>{c===3&&t.fillRect(n+l*r,s-(a+1)*r,r,r)})),t.globalAlpha=1}arrows(t,e,n,{axis:s,index:r,cell:o,x0:a,y0:c,longest:l,ratio:h}){let[d,u]=Ti[s];t.lineCap="round";for(let[f,p]of[["#ffffffc0",3.2],["#101418",1.5]]){t.strokeStyle=f,t.lineWidth=p*h*Math.min(1,o/(14*h)),t.beginPath();for(let y=0;y<e.n[u];y+=1)for(let m=0;m<e.n[d];m+=1){let g=[0,0,0];[g[s],g[d],g[u]]=[r,m,y];let v=kr(e,...g),[R,S]=[n[3*v+d],n[3*v+u]];if(R!==R||Math.hypot(R,S)<.02*l)continue;let C=.95*o/l,[M,_]=[a+(m+.5)*o,c-(y+.5)*o],[b,F]=[R*C,-S*C],[A,P]=[M+b/2,_+F/2];t.moveTo(M-b/2,_-F/2),t.lineTo(A,P);let[D,O]=[.3,.17];t.moveTo(A-D*b-O*F,P-D*F+O*b),t.lineTo(A,P),t.lineTo(A-D*b+O*F,P-D*F-O*b)}t.stroke()}}axes(t,e,{axis:n,ratio:s,x0:r,y0:o,w:a,hgt:c,ink:l}){let[h,d]=Ti[n];t.fillStyle=l,t.font=`${12*s}px system-ui, sans-serif`;let u=g=>[e.first[g]-e.spacing/2,e.first[g]+(e.n[g]-.5)*e.spacing],[f,p]=u(h),[y,m]=u(d);t.textBaseline="top",t.textAlign="left",t.fillText(Rn(f),r,o+c+6*s),t.textAlign="right",t.fillText(Rn(p),r+a,o+c+6*s),t.textAlign="center",t.fillText(`${"xyz"[h]} (mm)`,r+a/2,o+c+6*s),t.textAlign="right",t.textBaseline="bottom",t.fillText(Rn(y),r-6*s,o+c),t.textBaseline="top",t.fillText(Rn(m),r-6*s,o),t.textBaseline="middle",t.fillText(`${"xyz"[d]}`,r-6*s,o+c/2)}};var Am="uvw",ea={u_mean:"mean of u",v_mean:"mean of v",w_mean:"mean of w",u_rms:"rms of u",v_rms:"rms of v",w_rms:"rms of w",uu:"Reynolds stress uu",vv:"Reynolds stress vv",ww:"Reynolds stress ww",uv:"Reynolds stress uv",uw:"Reynolds stress uw",vw:"Reynolds stress vw",u_skewness:"skewness of u",v_skewness:"skewness of v",w_skewness:"skewness of w"},Du={value:"value",half:"half of its 95 % interval",uncertainty:"standard uncertainty",flow:"its part due to the flow",measurement:"its part due to the measurement",samples:"valid vectors"},Rm={0:"x",1:"y",2:"z"},cy={"m/s":"m/s","m2/s2":"m²/s²",1:""},hy=.99,Cm=4;function Pm(i,t){let e={quantity:"u_mean",part:"value",axis:2,index:null,along:0,line:null,at:null},n=q("p",{class:"advice"}),s={shots:Gt("Shots",{title:"of the run, whose valid vectors are in the statistics"}),samples:Gt("Valid vectors at a point",{title:"median over the points that have any, and fewest"}),middle:Gt("Median over the points",{title:"of the chosen quantity, with the median half of its 95 % interval"}),here:Gt("On the line",{wide:!0,title:"value, 95 % interval, and the standard uncertainties due to the flow and to the measurement"}),scale:Gt("Integral scales of u, v, w",{title:"along the profile's axis, from the two-point correlation"})},r=ii("Quantity",ea,D=>S({quantity:D})),o=ii("Show",Du,D=>S({part:D})),a=ii("Slice across",Rm,D=>S({axis:Number(D),index:null,line:null,at:null}));a.input.value="2";let c=or("at",{max:1},D=>S({index:D})),l=ii("Profile along",Rm,D=>S({along:Number(D),line:null,at:null})),h=new jr((D,O)=>C(D,O));h.canvas.setAttribute("aria-label","Slice through the statistics of the run");let d=fr(),u=new zn({x:"position (mm)",y:"",alt:"The chosen quantity along the dashed line of the slice, with the bounds of its 95 % interval",series:[{label:"value"},{label:"95 % interval: upper bound"},{label:"95 % interval: lower bound"}]}),f=new zn({x:"shots",y:"m/s",alt:"How the mean settles with the number of shots",series:[{label:"uncertainty of the mean"},{label:"difference from the mean of all shots"},{label:"expected of independent shots"}]}),p=new zn({x:"shots",y:"rms difference (m/s)",alt:"How the rms of parts of the run differs from that of all shots",height:190,series:[{label:"rms difference from all shots"}]}),y=new zn({x:"separation (mm)",y:"coefficient",alt:"Two-point correlation of u, v and w",height:150,series:[{label:"u"},{label:"v"},{label:"w"}]}),m=q("p",{class:"hint"}),g=q("div",{class:"parts"},q("dl",{class:"readings"},...Object.values(s).map(D=>D.element)),q("div",{class:"two"},q("div",{},Be("Slice",q("div",{class:"controls"},a.element,c.element),h.canvas,d.element),Be("Convergence",m,f.element,p.element)),q("div",{},Be("Profile",q("div",{class:"controls"},l.element,q("p",{class:"hint"},"Press a place in the slice to move the line.")),u.element),Be("Two-point correlation",y.element)))),v=q("div",{class:"view statistics"},q("div",{class:"controls"},r.element,o.element),n,g);t.watch(()=>S());let R=()=>[e.quantity];function S(D={}){Object.assign(e,D),v.isConnected&&!v.hidden&&M()}function C(D,O){let I=t.now;if(!I)return;let[V,H]=Ti[e.axis];e.along===e.axis&&(e.along=V);let[z,ot,Y]=e.along===H?[V,D,O]:[H,O,D],J=(G,nt)=>Math.min(I.n[G]-1,Math.floor(nt*I.n[G]));S({line:J(z,ot),at:J(e.along,Y)})}function M(){t.want(R());let D=t.now,O=D?.maps[e.quantity];if($t(n,t.error??dy(i,D,O)),An(n,"data-tone",t.error?"doubt":null),g.hidden=!O,!O)return;let I=cy[O.unit]??O.unit,V=uy(D,O,e.part);_(D,V,e.part==="samples"?"":I),F(D,O,I),A(D),P(D,O,I)}function _(D,O,I){let V=D.n[e.axis];e.index=Math.min(V-1,e.index??Math.floor(V/2)),c.input.max=V-1,c.input.value=e.index,$t(c.shown,`${"xyz"[e.axis]} = ${Ht(D.first[e.axis]+e.index*D.spacing,2)} mm`);let[H,z]=Ti[e.axis];e.along===e.axis&&(e.along=H),l.input.value=String(e.along);let ot=e.along===H?z:H;e.line=Math.min(D.n[ot]-1,e.line??Math.floor(D.n[ot]/2)),e.at=Math.min(D.n[e.along]-1,e.at??Math.floor(D.n[e.along]/2));let Y=e.part==="value"&&!/_rms$|^(uu|vv|ww)$/.test(e.quantity),J=kn(O.map(Math.abs),hy),G=new fs(Y?-J:0,J,Y),nt={...D,status:new Uint8Array(O.length)},lt=new Float32Array(3*O.length).fill(NaN);h.draw(nt,O,lt,{axis:e.axis,index:e.index,scale:G,longest:1,line:{along:e.along===H?0:1,index:e.line}});let j=e.part==="value"?ea[e.quantity]:`${ea[e.quantity]}: ${Du[e.part]}`;e.part==="samples"?d.show(G,Du.samples,Rn):d.show(G,I?`${j} (${I})`:j)}function b(D,O){let I=3-e.axis-e.along,V=[0,0,0];return[V[e.axis],V[e.along],V[I]]=[e.index,O,e.line],kr(D,...V)}function F(D,O,I){let V=[],H=[[],[],[]];for(let z=0;z<D.n[e.along];z+=1){let ot=b(D,z);V.push(D.first[e.along]+z*D.spacing),[O.value,O.high,O.low].forEach((Y,J)=>H[J].push(Number.isNaN(Y[ot])?null:Y[ot]))}u.label(I?`${ea[e.quantity]} (${I})`:ea[e.quantity]),u.show([V,...H])}function A({convergence:D,correlations:O}){let I=Am.indexOf(e.quantity[0]);$t(m,`Root mean square over the points, of ${Am[I]}, for parts of the run from a twenty-third to all of it.`);let V=D.map(Y=>Y.shots);f.show([V,...["mean_uncertainty_m_s","mean_difference_m_s","mean_difference_expected_m_s"].map(Y=>D.map(J=>J[Y][I]))]),p.show([V,D.map(Y=>Y.shots>1?Y.rms_difference_m_s[I]:null)]);let{separation_mm:H,coefficient:z,integral_scale_mm:ot}=O[e.along];y.show([H,...[0,1,2].map(Y=>z.map(J=>J[Y]))]),s.scale.show(`${ot.map(Y=>Ht(Y,2)).join(", ")} mm along ${"xyz"[e.along]}`)}function P(D,O,I){let V=i.status?.shots.done??D.shots;s.shots.show(D.shots<V?`${le(D.shots)} of ${le(V)}`:le(D.shots),D.shots<Cm?"doubt":null);let H=D.samples.map(nt=>nt>0?nt:NaN);s.samples.show(`${le(kn(H,.5))}, ${le(kn(H,0))} at least`);let z=D.samples.map((nt,lt)=>Yh(O,lt)),ot=kn(z,.5),Y=I?` ${I}`:"";s.middle.show(`${Ht(kn(O.value,.5))}${Number.isNaN(ot)?"":` ± ${Ht(ot,2)}`}${Y}`);let J=b(D,e.at),G=`${"xyz"[e.along]} = ${Ht(D.first[e.along]+e.at*D.spacing,2)} mm`;$t(s.here.element.querySelector("dt"),`On the line, at ${G}`),s.here.show(Number.isNaN(O.value[J])?"too few shots":Number.isNaN(O.low[J])?`${Ht(O.value[J])}${Y}`:`${Ht(O.value[J])}${Y}, 95 %: ${Ht(O.low[J])} to ${Ht(O.high[J])}; ${le(D.samples[J])} vectors`)}return{element:v,update:()=>t.want(R()),show:()=>M()}}function uy(i,t,e){return e==="samples"?i.samples:e==="half"?t.value.map((n,s)=>Yh(t,s)):e==="uncertainty"?t.value.map((n,s)=>nl(t,s)):t[e]}function dy(i,t,e){if(!t)return"Asked for …";if(t.shots<Cm)return"Intervals are known once there are some more shots.";let n=i.status?.shots.done??t.shots,s=t.shots<n?`${le(t.shots)} of the ${le(n)} shots measured so far`:`all ${le(t.shots)} shots measured so far`;return e?`Of the valid vectors of ${s}.`:""}var py=.35,my=300,Im=.2,gy=.25;function bl(i,t){let e=[];for(let n=0;n<i.status.length;n+=1)i.status[n]===0&&e.push(i.displacement[3*n+t]);return e}function Lm(i,t){let[e,n]=[1/0,-1/0];for(let o of i)e=Math.min(e,o),n=Math.max(n,o);n>e||([e,n]=Number.isFinite(e)?[e-.5,e+.5]:[0,1]);let s=(n-e)/t,r=new Array(t).fill(0);for(let o of i)r[Math.min(t-1,Math.floor((o-e)/s))]+=1;return{centres:r.map((o,a)=>e+(a+.5)*s),counts:r,width:s}}function _y(i){if(i.length<my)return null;let t=i.reduce((o,a)=>o+a,0)/i.length,e=i.reduce((o,a)=>o+(a-t)**2,0)/i.length;if(Math.sqrt(e)<py)return null;let[n,s]=[0,0];for(let o of i)n+=Math.cos(2*Math.PI*o),s+=Math.sin(2*Math.PI*o);let r=Math.exp(-2*Math.PI**2*e);return Math.max(0,Math.hypot(n,s)/i.length-r)}function Dm(i){let e=["x","y","z"].map((r,o)=>[r,_y(bl(i,o))]).filter(([,r])=>r!==null);if(e.length===0)return{text:"Peak locking cannot be judged: too few vectors, or displacements spread over less than a voxel.",tone:null};let n=e.filter(([,r])=>r>Im).map(([r])=>r),s=e.map(([r,o])=>`${r} ${o.toFixed(2)}`).join(", ");return n.length?{text:`Displacements lock to whole voxels along ${n.join(", ")} (${s}).`,tone:"doubt"}:{text:`No peak locking (first harmonic ${s}; above ${Im} is locking).`,tone:"good"}}function Nm(i,t){let e=Math.max(...[0,1,2].map(c=>kn(bl(i,c).map(Math.abs),.99)));if(!(e>0))return null;let n=gy*t/i.voxel,r=i.dt*1e6*n/e,o=e/(t/i.voxel),a=`largest displacement ${e.toFixed(1)} voxels, ${(100*o).toFixed(0)} % of a window`;return e>n?{text:`dt is too long: ${a}. Shorten it to ${Number(r.toPrecision(2))} µs.`,tone:"doubt",bestUs:r}:e<n/2?{text:`dt may be longer: ${a}. Up to ${Number(r.toPrecision(2))} µs keeps a quarter of a window, and errors weigh less.`,tone:null,bestUs:r}:{text:`dt suits the flow: ${a}.`,tone:"good",bestUs:r}}var js={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Qs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},ug=0,cd=1,dg=2;var Na=1,fg=2,Ro=3,tr=0,ni=1,ri=2,br=0,Co=1,hd=2,ud=3,dd=4,pg=5;var Mr=100,mg=101,gg=102,_g=103,xg=104,vg=200,yg=201,Sg=202,bg=203,fd=204,pd=205,Mg=206,wg=207,Tg=208,Eg=209,Ag=210,Rg=211,Cg=212,Pg=213,Ig=214,Kl=0,jl=1,Ql=2,go=3,tc=4,ec=5,nc=6,ic=7,Cc=0,Lg=1,Dg=2,es=0,md=1,gd=2,_d=3,xd=4,vd=5,yd=6,Sd=7;var bd=300,wr=301,Po=302,Pc=303,Ic=304,sc=1e3,ji=1001,rc=1002,Ln=1003,Ng=1004;var Ua=1005;var Un=1006,Lc=1007;var As=1008;var oi=1009,Md=1010,wd=1011,Io=1012,Dc=1013,zi=1014,Ri=1015,Vi=1016,Nc=1017,Uc=1018,Tr=1020,Td=35902,Ed=35899,Ad=1021,Rd=1022,yi=1023,bs=1026,Rs=1027,Fc=1028,Oc=1029,er=1030,Bc=1031;var kc=1033,Fa=33776,Oa=33777,Ba=33778,ka=33779,zc=35840,Vc=35841,Gc=35842,Hc=35843,Wc=36196,Xc=37492,qc=37496,Yc=37488,$c=37489,za=37490,Zc=37491,Jc=37808,Kc=37809,jc=37810,Qc=37811,th=37812,eh=37813,nh=37814,ih=37815,sh=37816,rh=37817,oh=37818,ah=37819,lh=37820,ch=37821,hh=36492,uh=36494,dh=36495,fh=36283,ph=36284,Va=36285,mh=36286;var ua=2300,oc=2301,Zl=2302,nd=2303,id=2400,sd=2401,rd=2402;var Ug=3200;var gh=0,Fg=1,Cs="",Hn="srgb",da="srgb-linear",fa="linear",Ie="srgb";var Jl=7680;var Og=519,Bg=512,kg=513,zg=514,Cd=515,Vg=516,Gg=517,Pd=518,Id=519,Hg=35044,_h=35048;var Ld="300 es",Ai=2e3,_o=2001;function xy(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function vy(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function pa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Wg(){let i=pa("canvas");return i.style.display="block",i}var Um={},xo=null;function Dd(...i){let t="THREE."+i.shift();xo?xo("log",t,...i):console.log(t,...i)}function Xg(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Jt(...i){i=Xg(i);let t="THREE."+i.shift();if(xo)xo("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function se(...i){i=Xg(i);let t="THREE."+i.shift();if(xo)xo("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function ca(...i){let t=i.join(" ");t in Um||(Um[t]=!0,Jt(...i))}function qg(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var Yg={[Kl]:Kl,[Ql]:nc,[tc]:tc,[go]:ec,[jl]:jl,[nc]:Ql,[ic]:ic,[ec]:go},ki=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Vn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Fm=1234567,po=Math.PI/180,vo=180/Math.PI;function Lo(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Vn[i&255]+Vn[i>>8&255]+Vn[i>>16&255]+Vn[i>>24&255]+"-"+Vn[t&255]+Vn[t>>8&255]+"-"+Vn[t>>16&15|64]+Vn[t>>24&255]+"-"+Vn[e&63|128]+Vn[e>>8&255]+"-"+Vn[e>>16&255]+Vn[e>>24&255]+Vn[n&255]+Vn[n>>8&255]+Vn[n>>16&255]+Vn[n>>24&255]).toLowerCase()}function _e(i,t,e){return Math.max(t,Math.min(e,i))}function Nd(i,t){return(i%t+t)%t}function yy(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function Sy(i,t,e){return i!==t?(e-i)/(t-i):0}function ha(i,t,e){return(1-e)*i+e*t}function by(i,t,e,n){return ha(i,t,1-Math.exp(-e*n))}function My(i,t=1){return t-Math.abs(Nd(i,t*2)-t)}function wy(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function Ty(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function Ey(i,t){return i+Math.floor(Math.random()*(t-i+1))}function Ay(i,t){return i+Math.random()*(t-i)}function Ry(i){return i*(.5-Math.random())}function Cy(i){i!==void 0&&(Fm=i);let t=Fm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Py(i){return i*po}function Iy(i){return i*vo}function Ly(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function Dy(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Ud(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Ny(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),c=o(e/2),l=r((t+n)/2),h=o((t+n)/2),d=r((t-n)/2),u=o((t-n)/2),f=r((n-t)/2),p=o((n-t)/2);switch(s){case"XYX":i.set(a*h,c*d,c*u,a*l);break;case"YZY":i.set(c*u,a*h,c*d,a*l);break;case"ZXZ":i.set(c*d,c*u,a*h,a*l);break;case"XZX":i.set(a*h,c*p,c*f,a*l);break;case"YXY":i.set(c*f,a*h,c*p,a*l);break;case"ZYZ":i.set(c*p,c*f,a*h,a*l);break;default:Jt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Fd(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function $g(i,t){if(t.constructor===Float32Array)return i;let e=Fd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Zg(i,t){if(t.constructor===Float32Array)return i;let e=Fd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var xh={DEG2RAD:po,RAD2DEG:vo,generateUUID:Lo,clamp:_e,euclideanModulo:Nd,mapLinear:yy,inverseLerp:Sy,lerp:ha,damp:by,pingpong:My,smoothstep:wy,smootherstep:Ty,randInt:Ey,randFloat:Ay,randFloatSpread:Ry,seededRandom:Cy,degToRad:Py,radToDeg:Iy,isPowerOfTwo:Ly,ceilPowerOfTwo:Dy,floorPowerOfTwo:Ud,setQuaternionFromProperEuler:Ny,normalize:Zg,denormalize:$g},ne=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=_e(this.x,t.x,e.x),this.y=_e(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=_e(this.x,t,e),this.y=_e(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_e(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(_e(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ei=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let c=n[s+0],l=n[s+1],h=n[s+2],d=n[s+3],u=r[o+0],f=r[o+1],p=r[o+2],y=r[o+3];if(d!==y||c!==u||l!==f||h!==p){let m=c*u+l*f+h*p+d*y;m<0&&(u=-u,f=-f,p=-p,y=-y,m=-m);let g=1-a;if(m<.9995){let v=Math.acos(m),R=Math.sin(v);g=Math.sin(g*v)/R,a=Math.sin(a*v)/R,c=c*g+u*a,l=l*g+f*a,h=h*g+p*a,d=d*g+y*a}else{c=c*g+u*a,l=l*g+f*a,h=h*g+p*a,d=d*g+y*a;let v=1/Math.sqrt(c*c+l*l+h*h+d*d);c*=v,l*=v,h*=v,d*=v}}t[e]=c,t[e+1]=l,t[e+2]=h,t[e+3]=d}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],c=n[s+1],l=n[s+2],h=n[s+3],d=r[o],u=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+h*d+c*f-l*u,t[e+1]=c*p+h*u+l*d-a*f,t[e+2]=l*p+h*f+a*u-c*d,t[e+3]=h*p-a*d-c*u-l*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(n/2),h=a(s/2),d=a(r/2),u=c(n/2),f=c(s/2),p=c(r/2);switch(o){case"XYZ":this._x=u*h*d+l*f*p,this._y=l*f*d-u*h*p,this._z=l*h*p+u*f*d,this._w=l*h*d-u*f*p;break;case"YXZ":this._x=u*h*d+l*f*p,this._y=l*f*d-u*h*p,this._z=l*h*p-u*f*d,this._w=l*h*d+u*f*p;break;case"ZXY":this._x=u*h*d-l*f*p,this._y=l*f*d+u*h*p,this._z=l*h*p+u*f*d,this._w=l*h*d-u*f*p;break;case"ZYX":this._x=u*h*d-l*f*p,this._y=l*f*d+u*h*p,this._z=l*h*p-u*f*d,this._w=l*h*d+u*f*p;break;case"YZX":this._x=u*h*d+l*f*p,this._y=l*f*d+u*h*p,this._z=l*h*p-u*f*d,this._w=l*h*d-u*f*p;break;case"XZY":this._x=u*h*d-l*f*p,this._y=l*f*d-u*h*p,this._z=l*h*p+u*f*d,this._w=l*h*d+u*f*p;break;default:Jt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],c=e[9],l=e[2],h=e[6],d=e[10],u=n+a+d;if(u>0){let f=.5/Math.sqrt(u+1);this._w=.25/f,this._x=(h-c)*f,this._y=(r-l)*f,this._z=(o-s)*f}else if(n>a&&n>d){let f=2*Math.sqrt(1+n-a-d);this._w=(h-c)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+l)/f}else if(a>d){let f=2*Math.sqrt(1+a-n-d);this._w=(r-l)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(c+h)/f}else{let f=2*Math.sqrt(1+d-n-a);this._w=(o-s)/f,this._x=(r+l)/f,this._y=(c+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(_e(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,c=e._y,l=e._z,h=e._w;return this._x=n*h+o*a+s*l-r*c,this._y=s*h+o*c+r*a-n*l,this._z=r*h+o*l+n*c-s*a,this._w=o*h-n*a-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let c=1-e;if(a<.9995){let l=Math.acos(a),h=Math.sin(l);c=Math.sin(c*l)/h,e=Math.sin(e*l)/h,this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this._onChangeCallback()}else this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},$=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Om.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Om.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*s-a*n),h=2*(a*e-r*s),d=2*(r*n-o*e);return this.x=e+c*l+o*d-a*h,this.y=n+c*h+a*l-r*d,this.z=s+c*d+r*h-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=_e(this.x,t.x,e.x),this.y=_e(this.y,t.y,e.y),this.z=_e(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=_e(this.x,t,e),this.y=_e(this.y,t,e),this.z=_e(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_e(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,c=e.z;return this.x=s*c-r*a,this.y=r*o-n*c,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Nu.copy(this).projectOnVector(t),this.sub(Nu)}reflect(t){return this.sub(Nu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(_e(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Nu=new $,Om=new ei,re=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,c,l)}set(t,e,n,s,r,o,a,c,l){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=c,h[6]=n,h[7]=o,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],c=n[6],l=n[1],h=n[4],d=n[7],u=n[2],f=n[5],p=n[8],y=s[0],m=s[3],g=s[6],v=s[1],R=s[4],S=s[7],C=s[2],M=s[5],_=s[8];return r[0]=o*y+a*v+c*C,r[3]=o*m+a*R+c*M,r[6]=o*g+a*S+c*_,r[1]=l*y+h*v+d*C,r[4]=l*m+h*R+d*M,r[7]=l*g+h*S+d*_,r[2]=u*y+f*v+p*C,r[5]=u*m+f*R+p*M,r[8]=u*g+f*S+p*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8];return e*o*h-e*a*l-n*r*h+n*a*c+s*r*l-s*o*c}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],d=h*o-a*l,u=a*c-h*r,f=l*r-o*c,p=e*d+n*u+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/p;return t[0]=d*y,t[1]=(s*l-h*n)*y,t[2]=(a*n-s*o)*y,t[3]=u*y,t[4]=(h*e-s*c)*y,t[5]=(s*r-a*e)*y,t[6]=f*y,t[7]=(n*c-l*e)*y,t[8]=(o*e-n*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*o+l*a)+o+t,-s*l,s*c,-s*(-l*o+c*a)+a+e,0,0,1),this}scale(t,e){return ca("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Uu.makeScale(t,e)),this}rotate(t){return ca("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Uu.makeRotation(-t)),this}translate(t,e){return ca("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Uu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Uu=new re,Bm=new re().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),km=new re().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Uy(){let i={enabled:!0,workingColorSpace:da,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ie&&(s.r=Ss(s.r),s.g=Ss(s.g),s.b=Ss(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ie&&(s.r=mo(s.r),s.g=mo(s.g),s.b=mo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Cs?fa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[da]:{primaries:t,whitePoint:n,transfer:fa,toXYZ:Bm,fromXYZ:km,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Hn},outputColorSpaceConfig:{drawingBufferColorSpace:Hn}},[Hn]:{primaries:t,whitePoint:n,transfer:Ie,toXYZ:Bm,fromXYZ:km,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Hn}}}),i}var Se=Uy();function Ss(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function mo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Qr,ac=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Qr===void 0&&(Qr=pa("canvas")),Qr.width=t.width,Qr.height=t.height;let s=Qr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Qr}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=pa("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ss(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Ss(e[n]/255)*255):e[n]=Ss(e[n]);return{data:e,width:t.width,height:t.height}}else return Jt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Fy=0,yo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Fy++}),this.uuid=Lo(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Fu(s[o].image)):r.push(Fu(s[o]))}else r=Fu(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function Fu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ac.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Jt("Texture: Unable to serialize Texture."),{})}var Oy=0,Ou=new $,si=class i extends ki{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=ji,s=ji,r=Un,o=As,a=yi,c=oi,l=i.DEFAULT_ANISOTROPY,h=Cs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Oy++}),this.uuid=Lo(),this.name="",this.source=new yo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new ne(0,0),this.repeat=new ne(1,1),this.center=new ne(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new re,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Ou).x}get height(){return this.source.getSize(Ou).y}get depth(){return this.source.getSize(Ou).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Jt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Jt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==bd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case sc:t.x=t.x-Math.floor(t.x);break;case ji:t.x=t.x<0?0:1;break;case rc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case sc:t.y=t.y-Math.floor(t.y);break;case ji:t.y=t.y<0?0:1;break;case rc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};si.DEFAULT_IMAGE=null;si.DEFAULT_MAPPING=bd;si.DEFAULT_ANISOTROPY=1;var Ze=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,c=t.elements,l=c[0],h=c[4],d=c[8],u=c[1],f=c[5],p=c[9],y=c[2],m=c[6],g=c[10];if(Math.abs(h-u)<.01&&Math.abs(d-y)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+y)<.1&&Math.abs(p+m)<.1&&Math.abs(l+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let R=(l+1)/2,S=(f+1)/2,C=(g+1)/2,M=(h+u)/4,_=(d+y)/4,b=(p+m)/4;return R>S&&R>C?R<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(R),s=M/n,r=_/n):S>C?S<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),n=M/s,r=b/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=_/r,s=b/r),this.set(n,s,r,e),this}let v=Math.sqrt((m-p)*(m-p)+(d-y)*(d-y)+(u-h)*(u-h));return Math.abs(v)<.001&&(v=1),this.x=(m-p)/v,this.y=(d-y)/v,this.z=(u-h)/v,this.w=Math.acos((l+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=_e(this.x,t.x,e.x),this.y=_e(this.y,t.y,e.y),this.z=_e(this.z,t.z,e.z),this.w=_e(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=_e(this.x,t,e),this.y=_e(this.y,t,e),this.z=_e(this.z,t,e),this.w=_e(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_e(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},lc=class extends ki{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Un,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Ze(0,0,t,e),this.scissorTest=!1,this.viewport=new Ze(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new si({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Un,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new yo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},xi=class extends lc{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},ma=class extends si{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Ln,this.minFilter=Ln,this.wrapR=ji,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var cc=class extends si{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Ln,this.minFilter=Ln,this.wrapR=ji,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Ae=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,c,l,h,d,u,f,p,y,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,c,l,h,d,u,f,p,y,m)}set(t,e,n,s,r,o,a,c,l,h,d,u,f,p,y,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=c,g[2]=l,g[6]=h,g[10]=d,g[14]=u,g[3]=f,g[7]=p,g[11]=y,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/to.setFromMatrixColumn(t,0).length(),r=1/to.setFromMatrixColumn(t,1).length(),o=1/to.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),c=Math.cos(s),l=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let u=o*h,f=o*d,p=a*h,y=a*d;e[0]=c*h,e[4]=-c*d,e[8]=l,e[1]=f+p*l,e[5]=u-y*l,e[9]=-a*c,e[2]=y-u*l,e[6]=p+f*l,e[10]=o*c}else if(t.order==="YXZ"){let u=c*h,f=c*d,p=l*h,y=l*d;e[0]=u+y*a,e[4]=p*a-f,e[8]=o*l,e[1]=o*d,e[5]=o*h,e[9]=-a,e[2]=f*a-p,e[6]=y+u*a,e[10]=o*c}else if(t.order==="ZXY"){let u=c*h,f=c*d,p=l*h,y=l*d;e[0]=u-y*a,e[4]=-o*d,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*h,e[9]=y-u*a,e[2]=-o*l,e[6]=a,e[10]=o*c}else if(t.order==="ZYX"){let u=o*h,f=o*d,p=a*h,y=a*d;e[0]=c*h,e[4]=p*l-f,e[8]=u*l+y,e[1]=c*d,e[5]=y*l+u,e[9]=f*l-p,e[2]=-l,e[6]=a*c,e[10]=o*c}else if(t.order==="YZX"){let u=o*c,f=o*l,p=a*c,y=a*l;e[0]=c*h,e[4]=y-u*d,e[8]=p*d+f,e[1]=d,e[5]=o*h,e[9]=-a*h,e[2]=-l*h,e[6]=f*d+p,e[10]=u-y*d}else if(t.order==="XZY"){let u=o*c,f=o*l,p=a*c,y=a*l;e[0]=c*h,e[4]=-d,e[8]=l*h,e[1]=u*d+y,e[5]=o*h,e[9]=f*d-p,e[2]=p*d-f,e[6]=a*h,e[10]=y*d+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(By,t,ky)}lookAt(t,e,n){let s=this.elements;return mi.subVectors(t,e),mi.lengthSq()===0&&(mi.z=1),mi.normalize(),Gs.crossVectors(n,mi),Gs.lengthSq()===0&&(Math.abs(n.z)===1?mi.x+=1e-4:mi.z+=1e-4,mi.normalize(),Gs.crossVectors(n,mi)),Gs.normalize(),Ml.crossVectors(mi,Gs),s[0]=Gs.x,s[4]=Ml.x,s[8]=mi.x,s[1]=Gs.y,s[5]=Ml.y,s[9]=mi.y,s[2]=Gs.z,s[6]=Ml.z,s[10]=mi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],c=n[8],l=n[12],h=n[1],d=n[5],u=n[9],f=n[13],p=n[2],y=n[6],m=n[10],g=n[14],v=n[3],R=n[7],S=n[11],C=n[15],M=s[0],_=s[4],b=s[8],F=s[12],A=s[1],P=s[5],D=s[9],O=s[13],I=s[2],V=s[6],H=s[10],z=s[14],ot=s[3],Y=s[7],J=s[11],G=s[15];return r[0]=o*M+a*A+c*I+l*ot,r[4]=o*_+a*P+c*V+l*Y,r[8]=o*b+a*D+c*H+l*J,r[12]=o*F+a*O+c*z+l*G,r[1]=h*M+d*A+u*I+f*ot,r[5]=h*_+d*P+u*V+f*Y,r[9]=h*b+d*D+u*H+f*J,r[13]=h*F+d*O+u*z+f*G,r[2]=p*M+y*A+m*I+g*ot,r[6]=p*_+y*P+m*V+g*Y,r[10]=p*b+y*D+m*H+g*J,r[14]=p*F+y*O+m*z+g*G,r[3]=v*M+R*A+S*I+C*ot,r[7]=v*_+R*P+S*V+C*Y,r[11]=v*b+R*D+S*H+C*J,r[15]=v*F+R*O+S*z+C*G,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],c=t[9],l=t[13],h=t[2],d=t[6],u=t[10],f=t[14],p=t[3],y=t[7],m=t[11],g=t[15],v=c*f-l*u,R=a*f-l*d,S=a*u-c*d,C=o*f-l*h,M=o*u-c*h,_=o*d-a*h;return e*(y*v-m*R+g*S)-n*(p*v-m*C+g*M)+s*(p*R-y*C+g*_)-r*(p*S-y*M+m*_)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],c=t[2],l=t[6],h=t[10];return e*(o*h-a*l)-n*(r*h-a*c)+s*(r*l-o*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],d=t[9],u=t[10],f=t[11],p=t[12],y=t[13],m=t[14],g=t[15],v=e*a-n*o,R=e*c-s*o,S=e*l-r*o,C=n*c-s*a,M=n*l-r*a,_=s*l-r*c,b=h*y-d*p,F=h*m-u*p,A=h*g-f*p,P=d*m-u*y,D=d*g-f*y,O=u*g-f*m,I=v*O-R*D+S*P+C*A-M*F+_*b;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/I;return t[0]=(a*O-c*D+l*P)*V,t[1]=(s*D-n*O-r*P)*V,t[2]=(y*_-m*M+g*C)*V,t[3]=(u*M-d*_-f*C)*V,t[4]=(c*A-o*O-l*F)*V,t[5]=(e*O-s*A+r*F)*V,t[6]=(m*S-p*_-g*R)*V,t[7]=(h*_-u*S+f*R)*V,t[8]=(o*D-a*A+l*b)*V,t[9]=(n*A-e*D-r*b)*V,t[10]=(p*M-y*S+g*v)*V,t[11]=(d*S-h*M-f*v)*V,t[12]=(a*F-o*P-c*b)*V,t[13]=(e*P-n*F+s*b)*V,t[14]=(y*R-p*C-m*v)*V,t[15]=(h*C-d*R+u*v)*V,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,c=t.z,l=r*o,h=r*a;return this.set(l*o+n,l*a-s*c,l*c+s*a,0,l*a+s*c,h*a+n,h*c-s*o,0,l*c-s*a,h*c+s*o,r*c*c+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,c=e._w,l=r+r,h=o+o,d=a+a,u=r*l,f=r*h,p=r*d,y=o*h,m=o*d,g=a*d,v=c*l,R=c*h,S=c*d,C=n.x,M=n.y,_=n.z;return s[0]=(1-(y+g))*C,s[1]=(f+S)*C,s[2]=(p-R)*C,s[3]=0,s[4]=(f-S)*M,s[5]=(1-(u+g))*M,s[6]=(m+v)*M,s[7]=0,s[8]=(p+R)*_,s[9]=(m-v)*_,s[10]=(1-(u+y))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=to.set(s[0],s[1],s[2]).length(),a=to.set(s[4],s[5],s[6]).length(),c=to.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Fi.copy(this);let l=1/o,h=1/a,d=1/c;return Fi.elements[0]*=l,Fi.elements[1]*=l,Fi.elements[2]*=l,Fi.elements[4]*=h,Fi.elements[5]*=h,Fi.elements[6]*=h,Fi.elements[8]*=d,Fi.elements[9]*=d,Fi.elements[10]*=d,e.setFromRotationMatrix(Fi),n.x=o,n.y=a,n.z=c,this}makePerspective(t,e,n,s,r,o,a=Ai,c=!1){let l=this.elements,h=2*r/(e-t),d=2*r/(n-s),u=(e+t)/(e-t),f=(n+s)/(n-s),p,y;if(c)p=r/(o-r),y=o*r/(o-r);else if(a===Ai)p=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===_o)p=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=u,l[12]=0,l[1]=0,l[5]=d,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=p,l[14]=y,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Ai,c=!1){let l=this.elements,h=2/(e-t),d=2/(n-s),u=-(e+t)/(e-t),f=-(n+s)/(n-s),p,y;if(c)p=1/(o-r),y=o/(o-r);else if(a===Ai)p=-2/(o-r),y=-(o+r)/(o-r);else if(a===_o)p=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=0,l[12]=u,l[1]=0,l[5]=d,l[9]=0,l[13]=f,l[2]=0,l[6]=0,l[10]=p,l[14]=y,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},to=new $,Fi=new Ae,By=new $(0,0,0),ky=new $(1,1,1),Gs=new $,Ml=new $,mi=new $,zm=new Ae,Vm=new ei,Ms=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],h=s[9],d=s[2],u=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(_e(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,l),this._z=0);break;case"YXZ":this._x=Math.asin(-_e(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(_e(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-_e(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,f),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(_e(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-_e(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Jt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return zm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(zm,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Vm.setFromEuler(this),this.setFromQuaternion(Vm,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ms.DEFAULT_ORDER="XYZ";var ga=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},zy=0,Gm=new $,eo=new ei,ps=new Ae,wl=new $,na=new $,Vy=new $,Gy=new ei,Hm=new $(1,0,0),Wm=new $(0,1,0),Xm=new $(0,0,1),qm={type:"added"},Hy={type:"removed"},no={type:"childadded",child:null},Bu={type:"childremoved",child:null},Xn=class i extends ki{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:zy++}),this.uuid=Lo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new $,e=new Ms,n=new ei,s=new $(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ae},normalMatrix:{value:new re}}),this.matrix=new Ae,this.matrixWorld=new Ae,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ga,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return eo.setFromAxisAngle(t,e),this.quaternion.multiply(eo),this}rotateOnWorldAxis(t,e){return eo.setFromAxisAngle(t,e),this.quaternion.premultiply(eo),this}rotateX(t){return this.rotateOnAxis(Hm,t)}rotateY(t){return this.rotateOnAxis(Wm,t)}rotateZ(t){return this.rotateOnAxis(Xm,t)}translateOnAxis(t,e){return Gm.copy(t).applyQuaternion(this.quaternion),this.position.add(Gm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Hm,t)}translateY(t){return this.translateOnAxis(Wm,t)}translateZ(t){return this.translateOnAxis(Xm,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ps.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?wl.copy(t):wl.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),na.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ps.lookAt(na,wl,this.up):ps.lookAt(wl,na,this.up),this.quaternion.setFromRotationMatrix(ps),s&&(ps.extractRotation(s.matrixWorld),eo.setFromRotationMatrix(ps),this.quaternion.premultiply(eo.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(se("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(qm),no.child=t,this.dispatchEvent(no),no.child=null):se("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Hy),Bu.child=t,this.dispatchEvent(Bu),Bu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ps.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ps.multiply(t.parent.matrixWorld)),t.applyMatrix4(ps),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(qm),no.child=t,this.dispatchEvent(no),no.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,t,Vy),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,Gy,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let d=c[l];r(t.shapes,d)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(t.materials,this.material[c]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(t.animations,c))}}if(e){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),h=o(t.images),d=o(t.shapes),u=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(n.geometries=a),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),h.length>0&&(n.images=h),d.length>0&&(n.shapes=d),u.length>0&&(n.skeletons=u),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let c=[];for(let l in a){let h=a[l];delete h.metadata,c.push(h)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Xn.DEFAULT_UP=new $(0,1,0);Xn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Xn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ys=class extends Xn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Wy={type:"move"},So=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ys,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ys,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new $,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new $),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ys,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new $,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new $,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){o=!0;for(let y of t.hand.values()){let m=e.getJointPose(y,n),g=this._getHandJoint(l,y);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=l.joints["index-finger-tip"],d=l.joints["thumb-tip"],u=h.position.distanceTo(d.position),f=.02,p=.005;l.inputState.pinching&&u>f+p?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&u<=f-p&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Wy)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new ys;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},Jg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Hs={h:0,s:0,l:0},Tl={h:0,s:0,l:0};function ku(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var pe=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Hn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Se.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=Se.workingColorSpace){return this.r=t,this.g=e,this.b=n,Se.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=Se.workingColorSpace){if(t=Nd(t,1),e=_e(e,0,1),n=_e(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=ku(o,r,t+1/3),this.g=ku(o,r,t),this.b=ku(o,r,t-1/3)}return Se.colorSpaceToWorking(this,s),this}setStyle(t,e=Hn){function n(r){r!==void 0&&parseFloat(r)<1&&Jt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Jt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Jt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Hn){let n=Jg[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Jt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Ss(t.r),this.g=Ss(t.g),this.b=Ss(t.b),this}copyLinearToSRGB(t){return this.r=mo(t.r),this.g=mo(t.g),this.b=mo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Hn){return Se.workingToColorSpace(Gn.copy(this),t),Math.round(_e(Gn.r*255,0,255))*65536+Math.round(_e(Gn.g*255,0,255))*256+Math.round(_e(Gn.b*255,0,255))}getHexString(t=Hn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Se.workingColorSpace){Se.workingToColorSpace(Gn.copy(this),e);let n=Gn.r,s=Gn.g,r=Gn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),c,l,h=(a+o)/2;if(a===o)c=0,l=0;else{let d=o-a;switch(l=h<=.5?d/(o+a):d/(2-o-a),o){case n:c=(s-r)/d+(s<r?6:0);break;case s:c=(r-n)/d+2;break;case r:c=(n-s)/d+4;break}c/=6}return t.h=c,t.s=l,t.l=h,t}getRGB(t,e=Se.workingColorSpace){return Se.workingToColorSpace(Gn.copy(this),e),t.r=Gn.r,t.g=Gn.g,t.b=Gn.b,t}getStyle(t=Hn){Se.workingToColorSpace(Gn.copy(this),t);let e=Gn.r,n=Gn.g,s=Gn.b;return t!==Hn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Hs),this.setHSL(Hs.h+t,Hs.s+e,Hs.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Hs),t.getHSL(Tl);let n=ha(Hs.h,Tl.h,e),s=ha(Hs.s,Tl.s,e),r=ha(Hs.l,Tl.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Gn=new pe;pe.NAMES=Jg;var _a=class extends Xn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ms,this.environmentIntensity=1,this.environmentRotation=new Ms,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Oi=new $,ms=new $,zu=new $,gs=new $,io=new $,so=new $,Ym=new $,Vu=new $,Gu=new $,Hu=new $,Wu=new Ze,Xu=new Ze,qu=new Ze,vs=class i{constructor(t=new $,e=new $,n=new $){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Oi.subVectors(t,e),s.cross(Oi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Oi.subVectors(s,e),ms.subVectors(n,e),zu.subVectors(t,e);let o=Oi.dot(Oi),a=Oi.dot(ms),c=Oi.dot(zu),l=ms.dot(ms),h=ms.dot(zu),d=o*l-a*a;if(d===0)return r.set(0,0,0),null;let u=1/d,f=(l*c-a*h)*u,p=(o*h-a*c)*u;return r.set(1-f-p,p,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,gs)===null?!1:gs.x>=0&&gs.y>=0&&gs.x+gs.y<=1}static getInterpolation(t,e,n,s,r,o,a,c){return this.getBarycoord(t,e,n,s,gs)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,gs.x),c.addScaledVector(o,gs.y),c.addScaledVector(a,gs.z),c)}static getInterpolatedAttribute(t,e,n,s,r,o){return Wu.setScalar(0),Xu.setScalar(0),qu.setScalar(0),Wu.fromBufferAttribute(t,e),Xu.fromBufferAttribute(t,n),qu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Wu,r.x),o.addScaledVector(Xu,r.y),o.addScaledVector(qu,r.z),o}static isFrontFacing(t,e,n,s){return Oi.subVectors(n,e),ms.subVectors(t,e),Oi.cross(ms).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Oi.subVectors(this.c,this.b),ms.subVectors(this.a,this.b),Oi.cross(ms).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;io.subVectors(s,n),so.subVectors(r,n),Vu.subVectors(t,n);let c=io.dot(Vu),l=so.dot(Vu);if(c<=0&&l<=0)return e.copy(n);Gu.subVectors(t,s);let h=io.dot(Gu),d=so.dot(Gu);if(h>=0&&d<=h)return e.copy(s);let u=c*d-h*l;if(u<=0&&c>=0&&h<=0&&c-h>0)return o=c/(c-h),e.copy(n).addScaledVector(io,o);Hu.subVectors(t,r);let f=io.dot(Hu),p=so.dot(Hu);if(p>=0&&f<=p)return e.copy(r);let y=f*l-c*p;if(y<=0&&l>=0&&p<=0)return a=l/(l-p),e.copy(n).addScaledVector(so,a);let m=h*p-f*d;if(m<=0&&d-h>=0&&f-p>=0)return Ym.subVectors(r,s),a=(d-h)/(d-h+(f-p)),e.copy(s).addScaledVector(Ym,a);let g=1/(m+y+u);return o=y*g,a=u*g,e.copy(n).addScaledVector(io,o).addScaledVector(so,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Qi=class{constructor(t=new $(1/0,1/0,1/0),e=new $(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Bi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Bi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Bi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Bi):Bi.fromBufferAttribute(r,o),Bi.applyMatrix4(t.matrixWorld),this.expandByPoint(Bi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),El.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),El.copy(n.boundingBox)),El.applyMatrix4(t.matrixWorld),this.union(El)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Bi),Bi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ia),Al.subVectors(this.max,ia),ro.subVectors(t.a,ia),oo.subVectors(t.b,ia),ao.subVectors(t.c,ia),Ws.subVectors(oo,ro),Xs.subVectors(ao,oo),pr.subVectors(ro,ao);let e=[0,-Ws.z,Ws.y,0,-Xs.z,Xs.y,0,-pr.z,pr.y,Ws.z,0,-Ws.x,Xs.z,0,-Xs.x,pr.z,0,-pr.x,-Ws.y,Ws.x,0,-Xs.y,Xs.x,0,-pr.y,pr.x,0];return!Yu(e,ro,oo,ao,Al)||(e=[1,0,0,0,1,0,0,0,1],!Yu(e,ro,oo,ao,Al))?!1:(Rl.crossVectors(Ws,Xs),e=[Rl.x,Rl.y,Rl.z],Yu(e,ro,oo,ao,Al))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Bi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Bi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(_s[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),_s[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),_s[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),_s[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),_s[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),_s[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),_s[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),_s[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(_s),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},_s=[new $,new $,new $,new $,new $,new $,new $,new $],Bi=new $,El=new Qi,ro=new $,oo=new $,ao=new $,Ws=new $,Xs=new $,pr=new $,ia=new $,Al=new $,Rl=new $,mr=new $;function Yu(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){mr.fromArray(i,r);let a=s.x*Math.abs(mr.x)+s.y*Math.abs(mr.y)+s.z*Math.abs(mr.z),c=t.dot(mr),l=e.dot(mr),h=n.dot(mr);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>a)return!1}return!0}var fn=new $,Cl=new ne,Xy=0,Wn=class extends ki{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Xy++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Hg,this.updateRanges=[],this.gpuType=Ri,this.version=0,this._normalizationScale=t!==void 0?Fd(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Cl.fromBufferAttribute(this,e),Cl.applyMatrix3(t),this.setXY(e,Cl.x,Cl.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)fn.fromBufferAttribute(this,e),fn.applyMatrix3(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)fn.fromBufferAttribute(this,e),fn.applyMatrix4(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)fn.fromBufferAttribute(this,e),fn.applyNormalMatrix(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)fn.fromBufferAttribute(this,e),fn.transformDirection(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):$g(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Zg(t,this.array)}};var xa=class extends Wn{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var va=class extends Wn{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var xn=class extends Wn{constructor(t,e,n){super(new Float32Array(t),e,n)}},qy=new Qi,sa=new $,$u=new $,ws=class{constructor(t=new $,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):qy.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;sa.subVectors(t,this.center);let e=sa.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(sa,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):($u.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(sa.copy(t.center).add($u)),this.expandByPoint(sa.copy(t.center).sub($u))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Yy=0,Ei=new Ae,Zu=new Xn,lo=new $,gi=new Qi,ra=new Qi,In=new $,Fn=class i extends ki{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Yy++}),this.uuid=Lo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(xy(t)?va:xa)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new re().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ei.makeRotationFromQuaternion(t),this.applyMatrix4(Ei),this}rotateX(t){return Ei.makeRotationX(t),this.applyMatrix4(Ei),this}rotateY(t){return Ei.makeRotationY(t),this.applyMatrix4(Ei),this}rotateZ(t){return Ei.makeRotationZ(t),this.applyMatrix4(Ei),this}translate(t,e,n){return Ei.makeTranslation(t,e,n),this.applyMatrix4(Ei),this}scale(t,e,n){return Ei.makeScale(t,e,n),this.applyMatrix4(Ei),this}lookAt(t){return Zu.lookAt(t),Zu.updateMatrix(),this.applyMatrix4(Zu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(lo).negate(),this.translate(lo.x,lo.y,lo.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new xn(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Jt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Qi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){se("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new $(-1/0,-1/0,-1/0),new $(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];gi.setFromBufferAttribute(r),this.morphTargetsRelative?(In.addVectors(this.boundingBox.min,gi.min),this.boundingBox.expandByPoint(In),In.addVectors(this.boundingBox.max,gi.max),this.boundingBox.expandByPoint(In)):(this.boundingBox.expandByPoint(gi.min),this.boundingBox.expandByPoint(gi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&se('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ws);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){se("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new $,1/0);return}if(t){let n=this.boundingSphere.center;if(gi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];ra.setFromBufferAttribute(a),this.morphTargetsRelative?(In.addVectors(gi.min,ra.min),gi.expandByPoint(In),In.addVectors(gi.max,ra.max),gi.expandByPoint(In)):(gi.expandByPoint(ra.min),gi.expandByPoint(ra.max))}gi.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)In.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(In));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],c=this.morphTargetsRelative;for(let l=0,h=a.count;l<h;l++)In.fromBufferAttribute(a,l),c&&(lo.fromBufferAttribute(t,l),In.add(lo)),s=Math.max(s,n.distanceToSquared(In))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&se('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){se("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Wn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(n.count);for(let F=0;F<n.count;F++)a[F]=new $,c[F]=new $;let h=new $,d=new $,u=new $,f=new ne,p=new ne,y=new ne,m=new $,g=new $;function v(F,A,P){l[F]=l[A]=l[P]=1,h.fromBufferAttribute(n,F),d.fromBufferAttribute(n,A),u.fromBufferAttribute(n,P),f.fromBufferAttribute(r,F),p.fromBufferAttribute(r,A),y.fromBufferAttribute(r,P),d.sub(h),u.sub(h),p.sub(f),y.sub(f);let D=1/(p.x*y.y-y.x*p.y);isFinite(D)&&(m.copy(d).multiplyScalar(y.y).addScaledVector(u,-p.y).multiplyScalar(D),g.copy(u).multiplyScalar(p.x).addScaledVector(d,-y.x).multiplyScalar(D),a[F].add(m),a[A].add(m),a[P].add(m),c[F].add(g),c[A].add(g),c[P].add(g))}let R=this.groups;R.length===0&&(R=[{start:0,count:t.count}]);for(let F=0,A=R.length;F<A;++F){let P=R[F],D=P.start,O=P.count;for(let I=D,V=D+O;I<V;I+=3)v(t.getX(I+0),t.getX(I+1),t.getX(I+2))}let S=new $,C=new $,M=new $,_=new $;function b(F){M.fromBufferAttribute(s,F),_.copy(M);let A=a[F];S.copy(A),S.sub(M.multiplyScalar(M.dot(A))).normalize(),C.crossVectors(_,A);let D=C.dot(c[F])<0?-1:1;o.setXYZW(F,S.x,S.y,S.z,D)}for(let F=0,A=n.count;F<A;++F)l[F]&&b(F);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Wn(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let u=0,f=n.count;u<f;u++)n.setXYZ(u,0,0,0);let s=new $,r=new $,o=new $,a=new $,c=new $,l=new $,h=new $,d=new $;if(t)for(let u=0,f=t.count;u<f;u+=3){let p=t.getX(u+0),y=t.getX(u+1),m=t.getX(u+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,m),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),a.fromBufferAttribute(n,p),c.fromBufferAttribute(n,y),l.fromBufferAttribute(n,m),a.add(h),c.add(h),l.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(y,c.x,c.y,c.z),n.setXYZ(m,l.x,l.y,l.z)}else for(let u=0,f=e.count;u<f;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),o.fromBufferAttribute(e,u+2),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)In.fromBufferAttribute(t,e),In.normalize(),t.setXYZ(e,In.x,In.y,In.z)}toNonIndexed(){function t(a,c){let l=a.array,h=a.itemSize,d=a.normalized,u=new l.constructor(c.length*h),f=0,p=0;for(let y=0,m=c.length;y<m;y++){a.isInterleavedBufferAttribute?f=c[y]*a.data.stride+a.offset:f=c[y]*h;for(let g=0;g<h;g++)u[p++]=l[f++]}return new Wn(u,h,d)}if(this.index===null)return Jt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=t(c,n);e.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let h=0,d=l.length;h<d;h++){let u=l[h],f=t(u,n);c.push(f)}e.morphAttributes[a]=c}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let c in n){let l=n[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let d=0,u=l.length;d<u;d++){let f=l[d];h.push(f.toJSON(t.data))}h.length>0&&(s[c]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let l in s){let h=s[l];this.setAttribute(l,h.clone(e))}let r=t.morphAttributes;for(let l in r){let h=[],d=r[l];for(let u=0,f=d.length;u<f;u++)h.push(d[u].clone(e));this.morphAttributes[l]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,h=o.length;l<h;l++){let d=o[l];this.addGroup(d.start,d.count,d.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Ju=new $,$y=new $,Zy=new re,_i=class{constructor(t=new $(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Ju.subVectors(n,e).cross($y.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(Ju),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Zy.getNormalMatrix(t),s=this.coplanarPoint(Ju).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Jy=0,Ts=class extends ki{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Jy++}),this.uuid=Lo(),this.name="",this.type="Material",this.blending=Co,this.side=tr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=fd,this.blendDst=pd,this.blendEquation=Mr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new pe(0,0,0),this.blendAlpha=0,this.depthFunc=go,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Og,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Jl,this.stencilZFail=Jl,this.stencilZPass=Jl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Jt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Jt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new pe().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new _i().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new ne().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ne().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var xs=new $,Ku=new $,Pl=new $,Il=new $,xr=class{constructor(t=new $,e=new $(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,xs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=xs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(xs.copy(this.origin).addScaledVector(this.direction,e),xs.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Ku.copy(t).add(e).multiplyScalar(.5),Pl.copy(e).sub(t).normalize(),Il.copy(this.origin).sub(Ku);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Pl),a=Il.dot(this.direction),c=-Il.dot(Pl),l=Il.lengthSq(),h=Math.abs(1-o*o),d,u,f,p;if(h>0)if(d=o*c-a,u=o*a-c,p=r*h,d>=0)if(u>=-p)if(u<=p){let y=1/h;d*=y,u*=y,f=d*(d+o*u+2*a)+u*(o*d+u+2*c)+l}else u=r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*c)+l;else u=-r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*c)+l;else u<=-p?(d=Math.max(0,-(-o*r+a)),u=d>0?-r:Math.min(Math.max(-r,-c),r),f=-d*d+u*(u+2*c)+l):u<=p?(d=0,u=Math.min(Math.max(-r,-c),r),f=u*(u+2*c)+l):(d=Math.max(0,-(o*r+a)),u=d>0?r:Math.min(Math.max(-r,-c),r),f=-d*d+u*(u+2*c)+l);else u=o>0?-r:r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Ku).addScaledVector(Pl,u),f}intersectSphere(t,e){if(t.radius<0)return null;xs.subVectors(t.center,this.origin);let n=xs.dot(this.direction),s=xs.dot(xs)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,c=n+o;return c<0?null:a<0?this.at(c,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,c,l=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return l>=0?(n=(t.min.x-u.x)*l,s=(t.max.x-u.x)*l):(n=(t.max.x-u.x)*l,s=(t.min.x-u.x)*l),h>=0?(r=(t.min.y-u.y)*h,o=(t.max.y-u.y)*h):(r=(t.max.y-u.y)*h,o=(t.min.y-u.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(t.min.z-u.z)*d,c=(t.max.z-u.z)*d):(a=(t.max.z-u.z)*d,c=(t.min.z-u.z)*d),n>c||a>s)||((a>n||n!==n)&&(n=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,xs)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,h=a.z,d=t.x-o.x,u=t.y-o.y,f=t.z-o.z,p=e.x-o.x,y=e.y-o.y,m=e.z-o.z,g=n.x-o.x,v=n.y-o.y,R=n.z-o.z,S=Math.abs(c),C=Math.abs(l),M=Math.abs(h),_,b,F,A,P,D,O,I,V,H,z,ot;if(S>=C&&S>=M?(F=c,D=d,V=p,ot=g,c>=0?(_=l,b=h,A=u,P=f,O=y,I=m,H=v,z=R):(_=h,b=l,A=f,P=u,O=m,I=y,H=R,z=v)):C>=M?(F=l,D=u,V=y,ot=v,l>=0?(_=h,b=c,A=f,P=d,O=m,I=p,H=R,z=g):(_=c,b=h,A=d,P=f,O=p,I=m,H=g,z=R)):(F=h,D=f,V=m,ot=R,h>=0?(_=c,b=l,A=d,P=u,O=p,I=y,H=g,z=v):(_=l,b=c,A=u,P=d,O=y,I=p,H=v,z=g)),F===0)return null;let Y=_/F,J=b/F,G=1/F,nt=A-Y*D,lt=P-J*D,j=O-Y*V,ut=I-J*V,dt=H-Y*ot,gt=z-J*ot,pt=dt*ut-gt*j,Dt=nt*gt-lt*dt,qt=j*lt-ut*nt;if(s){if(pt<0||Dt<0||qt<0)return null}else if((pt<0||Dt<0||qt<0)&&(pt>0||Dt>0||qt>0))return null;let Ft=pt+Dt+qt;if(Ft===0)return null;let oe=G*(pt*D+Dt*V+qt*ot);return(Ft>0?oe<0:oe>0)?null:this.at(oe/Ft,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},bo=class extends Ts{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new pe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ms,this.combine=Cc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},$m=new Ae,gr=new xr,Ll=new ws,Zm=new $,Dl=new $,Nl=new $,Ul=new $,ju=new $,Fl=new $,Jm=new $,Ol=new $,qn=class extends Xn{constructor(t=new Fn,e=new bo){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Fl.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=a[c],d=r[c];h!==0&&(ju.fromBufferAttribute(d,t),o?Fl.addScaledVector(ju,h):Fl.addScaledVector(ju.sub(e),h))}e.add(Fl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Ll.copy(n.boundingSphere),Ll.applyMatrix4(r),gr.copy(t.ray).recast(t.near),!(Ll.containsPoint(gr.origin)===!1&&(gr.intersectSphere(Ll,Zm)===null||gr.origin.distanceToSquared(Zm)>(t.far-t.near)**2))&&($m.copy(r).invert(),gr.copy(t.ray).applyMatrix4($m),!(n.boundingBox!==null&&gr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,gr)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,y=u.length;p<y;p++){let m=u[p],g=o[m.materialIndex],v=Math.max(m.start,f.start),R=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let S=v,C=R;S<C;S+=3){let M=a.getX(S),_=a.getX(S+1),b=a.getX(S+2);s=Bl(this,g,t,n,l,h,d,M,_,b),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let m=p,g=y;m<g;m+=3){let v=a.getX(m),R=a.getX(m+1),S=a.getX(m+2);s=Bl(this,o,t,n,l,h,d,v,R,S),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let p=0,y=u.length;p<y;p++){let m=u[p],g=o[m.materialIndex],v=Math.max(m.start,f.start),R=Math.min(c.count,Math.min(m.start+m.count,f.start+f.count));for(let S=v,C=R;S<C;S+=3){let M=S,_=S+1,b=S+2;s=Bl(this,g,t,n,l,h,d,M,_,b),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),y=Math.min(c.count,f.start+f.count);for(let m=p,g=y;m<g;m+=3){let v=m,R=m+1,S=m+2;s=Bl(this,o,t,n,l,h,d,v,R,S),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function Ky(i,t,e,n,s,r,o,a){let c;if(t.side===ni?c=n.intersectTriangle(o,r,s,!0,a):c=n.intersectTriangle(s,r,o,t.side===tr,a),c===null)return null;Ol.copy(a),Ol.applyMatrix4(i.matrixWorld);let l=e.ray.origin.distanceTo(Ol);return l<e.near||l>e.far?null:{distance:l,point:Ol.clone(),object:i}}function Bl(i,t,e,n,s,r,o,a,c,l){i.getVertexPosition(a,Dl),i.getVertexPosition(c,Nl),i.getVertexPosition(l,Ul);let h=Ky(i,t,e,n,Dl,Nl,Ul,Jm);if(h){let d=new $;vs.getBarycoord(Jm,Dl,Nl,Ul,d),s&&(h.uv=vs.getInterpolatedAttribute(s,a,c,l,d,new ne)),r&&(h.uv1=vs.getInterpolatedAttribute(r,a,c,l,d,new ne)),o&&(h.normal=vs.getInterpolatedAttribute(o,a,c,l,d,new $),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:c,c:l,normal:new $,materialIndex:0};vs.getNormal(Dl,Nl,Ul,u.normal),h.face=u,h.barycoord=d}return h}var vr=class extends si{constructor(t=null,e=1,n=1,s,r,o,a,c,l=Ln,h=Ln,d,u){super(null,o,a,c,l,h,s,r,d,u),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Mo=class extends Wn{constructor(t,e,n,s=1){super(t,e,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},co=new Ae,Km=new Ae,kl=[],jm=new Qi,jy=new Ae,oa=new qn,aa=new ws,ya=class extends qn{constructor(t,e,n){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Mo(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,jy)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Qi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,co),jm.copy(t.boundingBox).applyMatrix4(co),this.boundingBox.union(jm)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new ws),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,co),aa.copy(t.boundingSphere).applyMatrix4(co),this.boundingSphere.union(aa)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let n=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=t*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(t,e){let n=this.matrixWorld,s=this.count;if(oa.geometry=this.geometry,oa.material=this.material,oa.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),aa.copy(this.boundingSphere),aa.applyMatrix4(n),t.ray.intersectsSphere(aa)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,co),Km.multiplyMatrices(n,co),oa.matrixWorld=Km,oa.raycast(t,kl);for(let o=0,a=kl.length;o<a;o++){let c=kl[o];c.instanceId=r,c.object=this,e.push(c)}kl.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Mo(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let n=e.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new vr(new Float32Array(s*this.count),s,this.count,Fc,Ri));let r=this.morphTexture.source.data.data,o=0;for(let l=0;l<n.length;l++)o+=n[l];let a=this.geometry.morphTargetsRelative?1:1-o,c=s*t;return r[c]=a,r.set(n,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},_r=new ws,Qy=new ne(.5,.5),zl=new $,Ys=class{constructor(t=new _i,e=new _i,n=new _i,s=new _i,r=new _i,o=new _i){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Ai,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],c=r[2],l=r[3],h=r[4],d=r[5],u=r[6],f=r[7],p=r[8],y=r[9],m=r[10],g=r[11],v=r[12],R=r[13],S=r[14],C=r[15];if(s[0].setComponents(l-o,f-h,g-p,C-v).normalize(),s[1].setComponents(l+o,f+h,g+p,C+v).normalize(),s[2].setComponents(l+a,f+d,g+y,C+R).normalize(),s[3].setComponents(l-a,f-d,g-y,C-R).normalize(),n)s[4].setComponents(c,u,m,S).normalize(),s[5].setComponents(l-c,f-u,g-m,C-S).normalize();else if(s[4].setComponents(l-c,f-u,g-m,C-S).normalize(),e===Ai)s[5].setComponents(l+c,f+u,g+m,C+S).normalize();else if(e===_o)s[5].setComponents(c,u,m,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),_r.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),_r.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(_r)}intersectsSprite(t){_r.center.set(0,0,0);let e=Qy.distanceTo(t.center);return _r.radius=.7071067811865476+e,_r.applyMatrix4(t.matrixWorld),this.intersectsSphere(_r)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(zl.x=s.normal.x>0?t.max.x:t.min.x,zl.y=s.normal.y>0?t.max.y:t.min.y,zl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(zl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Qm=new Ae,hc=class i{constructor(){this.coordinateSystem=Ai,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Qm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Ys),n[s].setFromProjectionMatrix(Qm,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Ys),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var wo=class extends Ts{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new pe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},uc=new $,dc=new $,tg=new Ae,la=new xr,Vl=new ws,Qu=new $,eg=new $,fc=class extends Xn{constructor(t=new Fn,e=new wo){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)uc.fromBufferAttribute(e,s-1),dc.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=uc.distanceTo(dc);t.setAttribute("lineDistance",new xn(n,1))}else Jt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Vl.copy(n.boundingSphere),Vl.applyMatrix4(s),Vl.radius+=r,t.ray.intersectsSphere(Vl)===!1)return;tg.copy(s).invert(),la.copy(t.ray).applyMatrix4(tg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,h=n.index,u=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let y=f,m=p-1;y<m;y+=l){let g=h.getX(y),v=h.getX(y+1),R=Gl(this,t,la,c,g,v,y);R&&e.push(R)}if(this.isLineLoop){let y=h.getX(p-1),m=h.getX(f),g=Gl(this,t,la,c,y,m,p-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let y=f,m=p-1;y<m;y+=l){let g=Gl(this,t,la,c,y,y+1,y);g&&e.push(g)}if(this.isLineLoop){let y=Gl(this,t,la,c,p-1,f,p-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Gl(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(uc.fromBufferAttribute(a,s),dc.fromBufferAttribute(a,r),e.distanceSqToSegment(uc,dc,Qu,eg)>n)return;Qu.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(Qu);if(!(l<t.near||l>t.far))return{distance:l,point:eg.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var ng=new $,ig=new $,Sa=class extends fc{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)ng.fromBufferAttribute(e,s),ig.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+ng.distanceTo(ig);t.setAttribute("lineDistance",new xn(n,1))}else Jt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ba=class extends si{constructor(t=[],e=wr,n,s,r,o,a,c,l,h){super(t,e,n,s,r,o,a,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Es=class extends si{constructor(t,e,n=zi,s,r,o,a=Ln,c=Ln,l,h=bs,d=1){if(h!==bs&&h!==Rs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:t,height:e,depth:d};super(u,s,r,o,a,c,h,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new yo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Ma=class extends Es{constructor(t,e=zi,n=wr,s,r,o=Ln,a=Ln,c,l=bs){let h={width:t,height:t,depth:1},d=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,c,l),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},wa=class extends si{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},$s=class i extends Fn{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],h=[],d=[],u=0,f=0;p("z","y","x",-1,-1,n,e,t,o,r,0),p("z","y","x",1,-1,n,e,-t,o,r,1),p("x","z","y",1,1,t,n,e,s,o,2),p("x","z","y",1,-1,t,n,-e,s,o,3),p("x","y","z",1,-1,t,e,n,s,r,4),p("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(c),this.setAttribute("position",new xn(l,3)),this.setAttribute("normal",new xn(h,3)),this.setAttribute("uv",new xn(d,2));function p(y,m,g,v,R,S,C,M,_,b,F){let A=S/_,P=C/b,D=S/2,O=C/2,I=M/2,V=_+1,H=b+1,z=0,ot=0,Y=new $;for(let J=0;J<H;J++){let G=J*P-O;for(let nt=0;nt<V;nt++){let lt=nt*A-D;Y[y]=lt*v,Y[m]=G*R,Y[g]=I,l.push(Y.x,Y.y,Y.z),Y[y]=0,Y[m]=0,Y[g]=M>0?1:-1,h.push(Y.x,Y.y,Y.z),d.push(nt/_),d.push(1-J/b),z+=1}}for(let J=0;J<b;J++)for(let G=0;G<_;G++){let nt=u+G+V*J,lt=u+G+V*(J+1),j=u+(G+1)+V*(J+1),ut=u+(G+1)+V*J;c.push(nt,lt,ut),c.push(lt,j,ut),ot+=6}a.addGroup(f,ot,F),f+=ot,u+=z}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var To=class i extends Fn{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let h=[],d=[],u=[],f=[],p=0,y=[],m=n/2,g=0;v(),o===!1&&(t>0&&R(!0),e>0&&R(!1)),this.setIndex(h),this.setAttribute("position",new xn(d,3)),this.setAttribute("normal",new xn(u,3)),this.setAttribute("uv",new xn(f,2));function v(){let S=new $,C=new $,M=0,_=(e-t)/n;for(let b=0;b<=r;b++){let F=[],A=b/r,P=A*(e-t)+t;for(let D=0;D<=s;D++){let O=D/s,I=O*c+a,V=Math.sin(I),H=Math.cos(I);C.x=P*V,C.y=-A*n+m,C.z=P*H,d.push(C.x,C.y,C.z),S.set(V,_,H).normalize(),u.push(S.x,S.y,S.z),f.push(O,1-A),F.push(p++)}y.push(F)}for(let b=0;b<s;b++)for(let F=0;F<r;F++){let A=y[F][b],P=y[F+1][b],D=y[F+1][b+1],O=y[F][b+1];(t>0||F!==0)&&(h.push(A,P,O),M+=3),(e>0||F!==r-1)&&(h.push(P,D,O),M+=3)}l.addGroup(g,M,0),g+=M}function R(S){let C=p,M=new ne,_=new $,b=0,F=S===!0?t:e,A=S===!0?1:-1;for(let D=1;D<=s;D++)d.push(0,m*A,0),u.push(0,A,0),f.push(.5,.5),p++;let P=p;for(let D=0;D<=s;D++){let I=D/s*c+a,V=Math.cos(I),H=Math.sin(I);_.x=F*H,_.y=m*A,_.z=F*V,d.push(_.x,_.y,_.z),u.push(0,A,0),M.x=V*.5+.5,M.y=H*.5*A+.5,f.push(M.x,M.y),p++}for(let D=0;D<s;D++){let O=C+D,I=P+D;S===!0?h.push(I,I+1,O):h.push(I+1,I,O),b+=3}l.addGroup(g,b,S===!0?1:2),g+=b}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Ta=class i extends To{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var Hl=new $,Wl=new $,td=new $,Xl=new vs,Ea=class extends Fn{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(po*e),o=t.getIndex(),a=t.getAttribute("position"),c=o?o.count:a.count,l=[0,0,0],h=["a","b","c"],d=new Array(3),u=new Map,f=[];for(let p=0;p<c;p+=3){o?(l[0]=o.getX(p),l[1]=o.getX(p+1),l[2]=o.getX(p+2)):(l[0]=p,l[1]=p+1,l[2]=p+2);let{a:y,b:m,c:g}=Xl;if(y.fromBufferAttribute(a,l[0]),m.fromBufferAttribute(a,l[1]),g.fromBufferAttribute(a,l[2]),Xl.getNormal(td),d[0]=`${Math.round(y.x*s)},${Math.round(y.y*s)},${Math.round(y.z*s)}`,d[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,d[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(d[0]===d[1]||d[1]===d[2]||d[2]===d[0]))for(let v=0;v<3;v++){let R=(v+1)%3,S=d[v],C=d[R],M=Xl[h[v]],_=Xl[h[R]],b=`${S}_${C}`,F=`${C}_${S}`,A=u.get(F);A?(td.dot(A.normal)<=r&&(f.push(M.x,M.y,M.z),f.push(_.x,_.y,_.z)),u.set(F,null)):u.has(b)||u.set(b,{index0:l[v],index1:l[R],normal:td.clone()})}}for(let p of u.values())if(p){let{index0:y,index1:m}=p;Hl.fromBufferAttribute(a,y),Wl.fromBufferAttribute(a,m),f.push(Hl.x,Hl.y,Hl.z),f.push(Wl.x,Wl.y,Wl.z)}this.setAttribute("position",new xn(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var yr=class i extends Fn{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),c=Math.floor(s),l=a+1,h=c+1,d=t/a,u=e/c,f=[],p=[],y=[],m=[];for(let g=0;g<h;g++){let v=g*u-o;for(let R=0;R<l;R++){let S=R*d-r;p.push(S,-v,0),y.push(0,0,1),m.push(R/a),m.push(1-g/c)}}for(let g=0;g<c;g++)for(let v=0;v<a;v++){let R=v+l*g,S=v+l*(g+1),C=v+1+l*(g+1),M=v+1+l*g;f.push(R,S,M),f.push(S,C,M)}this.setIndex(f),this.setAttribute("position",new xn(p,3)),this.setAttribute("normal",new xn(y,3)),this.setAttribute("uv",new xn(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};function Er(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(sg(s))s.isRenderTargetTexture?(Jt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(sg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Yn(i){let t={};for(let e=0;e<i.length;e++){let n=Er(i[e]);for(let s in n)t[s]=n[s]}return t}function sg(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function tS(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Od(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Se.workingColorSpace}var Kg={clone:Er,merge:Yn},eS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,nS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ts=class extends Ts{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=eS,this.fragmentShader=nS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Er(t.uniforms),this.uniformsGroups=tS(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new pe().setHex(s.value);break;case"v2":this.uniforms[n].value=new ne().fromArray(s.value);break;case"v3":this.uniforms[n].value=new $().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Ze().fromArray(s.value);break;case"m3":this.uniforms[n].value=new re().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Ae().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},pc=class extends ts{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Sr=class extends Ts{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new pe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new pe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=gh,this.normalScale=new ne(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ms,this.combine=Cc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},mc=class extends Ts{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Ug,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},gc=class extends Ts{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function ho(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function ql(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Zs=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},_c=class extends Zs{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:id,endingEnd:id}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case sd:r=t,a=2*e-n;break;case rd:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(c===void 0)switch(this.getSettings_().endingEnd){case sd:o=t,c=2*n-e;break;case rd:o=1,c=n+s[1]-s[0];break;default:o=t-1,c=e}let l=(n-e)*.5,h=this.valueSize;this._weightPrev=l/(e-a),this._weightNext=l/(c-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,f=this._weightNext,p=(n-e)/(s-e),y=p*p,m=y*p,g=-u*m+2*u*y-u*p,v=(1+u)*m+(-1.5-2*u)*y+(-.5+u)*p+1,R=(-1-f)*m+(1.5+f)*y+.5*p,S=f*m-f*y;for(let C=0;C!==a;++C)r[C]=g*o[h+C]+v*o[l+C]+R*o[c+C]+S*o[d+C];return r}},xc=class extends Zs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=(n-e)/(s-e),d=1-h;for(let u=0;u!==a;++u)r[u]=o[l+u]*d+o[c+u]*h;return r}},vc=class extends Zs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},yc=class extends Zs{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this.inTangents,d=this.outTangents;if(!h||!d){let p=(n-e)/(s-e),y=1-p;for(let m=0;m!==a;++m)r[m]=o[l+m]*y+o[c+m]*p;return r}let u=a*2,f=t-1;for(let p=0;p!==a;++p){let y=o[l+p],m=o[c+p],g=f*u+p*2,v=d[g],R=d[g+1],S=t*u+p*2,C=h[S],M=h[S+1],_=sS(n,e,v,C,s);r[p]=jg(_,y,R,M,m)}return r}};function jg(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function iS(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function sS(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=jg(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let c=iS(r,t,e,n,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var vi=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=ho(e,this.TimeBufferType),this.values=ho(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:ho(t.times,Array),values:ho(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),ql(t.settings)&&(n.settings={inTangents:ho(t.settings.inTangents,Array),outTangents:ho(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new vc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new xc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new _c(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new yc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ua:e=this.InterpolantFactoryMethodDiscrete;break;case oc:e=this.InterpolantFactoryMethodLinear;break;case Zl:e=this.InterpolantFactoryMethodSmooth;break;case nd:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Jt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ua;case this.InterpolantFactoryMethodLinear:return oc;case this.InterpolantFactoryMethodSmooth:return Zl;case this.InterpolantFactoryMethodBezier:return nd}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;ql(this.settings)&&(rg(this.settings.inTangents,t),rg(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;ql(this.settings)&&(og(this.settings.inTangents,t),og(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(se("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(se("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let c=n[a];if(typeof c=="number"&&isNaN(c)){se("KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){se("KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(s!==void 0&&vy(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){se("KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Zl,r=t.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=t[a],h=t[a+1];if(l!==h&&(a!==1||l!==t[0]))if(s)c=!0;else{let d=a*n,u=d-n,f=d+n;for(let p=0;p!==n;++p){let y=e[d+p];if(y!==e[u+p]||y!==e[f+p]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let d=a*n,u=o*n;for(let f=0;f!==n;++f)e[u+f]=e[d+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,c=o*n,l=0;l!==n;++l)e[c+l]=e[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,ql(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function rg(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function og(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}vi.prototype.ValueTypeName="";vi.prototype.TimeBufferType=Float32Array;vi.prototype.ValueBufferType=Float32Array;vi.prototype.DefaultInterpolation=oc;var Js=class extends vi{constructor(t,e,n){super(t,e,n)}};Js.prototype.ValueTypeName="bool";Js.prototype.ValueBufferType=Array;Js.prototype.DefaultInterpolation=ua;Js.prototype.InterpolantFactoryMethodLinear=void 0;Js.prototype.InterpolantFactoryMethodSmooth=void 0;var Sc=class extends vi{constructor(t,e,n,s){super(t,e,n,s)}};Sc.prototype.ValueTypeName="color";var bc=class extends vi{constructor(t,e,n,s){super(t,e,n,s)}};bc.prototype.ValueTypeName="number";var Mc=class extends Zs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(n-e)/(s-e),l=t*a;for(let h=l+a;l!==h;l+=4)ei.slerpFlat(r,0,o,l-a,o,l,c);return r}},Aa=class extends vi{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new Mc(this.times,this.values,this.getValueSize(),t)}};Aa.prototype.ValueTypeName="quaternion";Aa.prototype.InterpolantFactoryMethodSmooth=void 0;var Ks=class extends vi{constructor(t,e,n){super(t,e,n)}};Ks.prototype.ValueTypeName="string";Ks.prototype.ValueBufferType=Array;Ks.prototype.DefaultInterpolation=ua;Ks.prototype.InterpolantFactoryMethodLinear=void 0;Ks.prototype.InterpolantFactoryMethodSmooth=void 0;var wc=class extends vi{constructor(t,e,n,s){super(t,e,n,s)}};wc.prototype.ValueTypeName="vector";var Tc=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,d){return l.push(h,d),this},this.removeHandler=function(h){let d=l.indexOf(h);return d!==-1&&l.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=l.length;d<u;d+=2){let f=l[d],p=l[d+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Qg=new Tc,Ec=class{constructor(t){this.manager=t!==void 0?t:Qg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Ec.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ra=class extends Xn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new pe(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var ed=new Ae,ag=new $,lg=new $,Ac=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ne(512,512),this.mapType=oi,this.map=null,this.mapPass=null,this.matrix=new Ae,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Ys,this._frameExtents=new ne(1,1),this._viewportCount=1,this._viewports=[new Ze(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;ag.setFromMatrixPosition(t.matrixWorld),e.position.copy(ag),lg.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(lg),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){ed.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(ed,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;t.coordinateSystem===_o||t.reversedDepth?e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),e.multiply(ed)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Yl=new $,$l=new ei,Ki=new $,Ca=class extends Xn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ae,this.projectionMatrix=new Ae,this.projectionMatrixInverse=new Ae,this.coordinateSystem=Ai,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Yl,$l,Ki),Ki.x===1&&Ki.y===1&&Ki.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Yl,$l,Ki.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(Yl,$l,Ki),Ki.x===1&&Ki.y===1&&Ki.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Yl,$l,Ki.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},qs=new $,cg=new ne,hg=new ne,ti=class extends Ca{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=vo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(po*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return vo*2*Math.atan(Math.tan(po*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){qs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(qs.x,qs.y).multiplyScalar(-t/qs.z),qs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(qs.x,qs.y).multiplyScalar(-t/qs.z)}getViewSize(t,e){return this.getViewBounds(t,cg,hg),e.subVectors(hg,cg)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(po*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,e-=o.offsetY*n/l,s*=o.width/c,n*=o.height/l}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Pa=class extends Ca{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=h*this.view.offsetY,c=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},od=class extends Ac{constructor(){super(new Pa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ia=class extends Ra{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Xn.DEFAULT_UP),this.updateMatrix(),this.target=new Xn,this.shadow=new od}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},La=class extends Ra{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var uo=-90,fo=1,Eo=class extends Xn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ti(uo,fo,t,e);s.layers=this.layers,this.add(s);let r=new ti(uo,fo,t,e);r.layers=this.layers,this.add(r);let o=new ti(uo,fo,t,e);o.layers=this.layers,this.add(o);let a=new ti(uo,fo,t,e);a.layers=this.layers,this.add(a);let c=new ti(uo,fo,t,e);c.layers=this.layers,this.add(c);let l=new ti(uo,fo,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,c]=e;for(let l of e)this.remove(l);if(t===Ai)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===_o)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,h]=this.children,d=t.getRenderTarget(),u=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(n,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),n.texture.mipmapsAutoUpdate=y,t.setRenderTarget(n,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(d,u,f),t.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Rc=class extends ti{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Bd="\\[\\]\\.:\\/",rS=new RegExp("["+Bd+"]","g"),kd="[^"+Bd+"]",oS="[^"+Bd.replace("\\.","")+"]",aS=/((?:WC+[\/:])*)/.source.replace("WC",kd),lS=/(WCOD+)?/.source.replace("WCOD",oS),cS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",kd),hS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",kd),uS=new RegExp("^"+aS+lS+cS+hS+"$"),dS=["material","materials","bones","map"],ad=class{constructor(t,e,n){let s=n||Ye.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Ye=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(rS,"")}static parseTrackName(t){let e=uS.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);dS.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let c=n(a.children);if(c)return c}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Jt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=e.objectIndex;switch(n){case"materials":if(!t.material){se("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){se("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){se("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===l){l=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){se("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){se("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){se("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(l!==void 0){if(t[l]===void 0){se("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[s];if(o===void 0){let l=e.nodeName;se("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){se("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){se("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ye.Composite=ad;Ye.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ye.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ye.prototype.GetterByBindingType=[Ye.prototype._getValue_direct,Ye.prototype._getValue_array,Ye.prototype._getValue_arrayElement,Ye.prototype._getValue_toArray];Ye.prototype.SetterByBindingTypeAndVersioning=[[Ye.prototype._setValue_direct,Ye.prototype._setValue_direct_setNeedsUpdate,Ye.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_array,Ye.prototype._setValue_array_setNeedsUpdate,Ye.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_arrayElement,Ye.prototype._setValue_arrayElement_setNeedsUpdate,Ye.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_fromArray,Ye.prototype._setValue_fromArray_setNeedsUpdate,Ye.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var _A=new Float32Array(1);var Ao=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=_e(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(_e(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var ld=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var Da=class extends ki{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function zd(i,t,e,n){let s=fS(n);switch(e){case Ad:return i*t;case Fc:return i*t/s.components*s.byteLength;case Oc:return i*t/s.components*s.byteLength;case er:return i*t*2/s.components*s.byteLength;case Bc:return i*t*2/s.components*s.byteLength;case Rd:return i*t*3/s.components*s.byteLength;case yi:return i*t*4/s.components*s.byteLength;case kc:return i*t*4/s.components*s.byteLength;case Fa:case Oa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Ba:case ka:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Vc:case Hc:return Math.max(i,16)*Math.max(t,8)/4;case zc:case Gc:return Math.max(i,8)*Math.max(t,8)/2;case Wc:case Xc:case Yc:case $c:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case qc:case za:case Zc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Jc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Kc:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case jc:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Qc:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case th:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case eh:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case nh:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case ih:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case sh:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case rh:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case oh:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case ah:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case lh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case ch:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case hh:case uh:case dh:return Math.ceil(i/4)*Math.ceil(t/4)*16;case fh:case ph:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Va:case mh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function fS(i){switch(i){case oi:case Md:return{byteLength:1,components:1};case Io:case wd:case Vi:return{byteLength:2,components:1};case Nc:case Uc:return{byteLength:2,components:4};case zi:case Dc:case Ri:return{byteLength:4,components:1};case Td:case Ed:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Jt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function S0(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function yS(i){let t=new WeakMap;function e(a,c){let l=a.array,h=a.usage,d=l.byteLength,u=i.createBuffer();i.bindBuffer(c,u),i.bufferData(c,l,h),a.onUploadCallback();let f;if(l instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)f=i.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(l instanceof Int16Array)f=i.SHORT;else if(l instanceof Uint32Array)f=i.UNSIGNED_INT;else if(l instanceof Int32Array)f=i.INT;else if(l instanceof Int8Array)f=i.BYTE;else if(l instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:u,type:f,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:d}}function n(a,c,l){let h=c.array,d=c.updateRanges;if(i.bindBuffer(l,a),d.length===0)i.bufferSubData(l,0,h);else{d.sort((f,p)=>f.start-p.start);let u=0;for(let f=1;f<d.length;f++){let p=d[u],y=d[f];y.start<=p.start+p.count+1?p.count=Math.max(p.count,y.start+y.count-p.start):(++u,d[u]=y)}d.length=u+1;for(let f=0,p=d.length;f<p;f++){let y=d[f];i.bufferSubData(l,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=t.get(a);c&&(i.deleteBuffer(c.buffer),t.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=t.get(a);if(l===void 0)t.set(a,e(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var SS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,bS=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,MS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,wS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,TS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,ES=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,AS=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,RS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,CS=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,PS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,IS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,LS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,DS=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,NS=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,US=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,FS=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,OS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,BS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,kS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,zS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,VS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,GS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,HS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,WS=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,XS=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,qS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,YS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,$S=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,ZS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,JS="gl_FragColor = linearToOutputTexel( gl_FragColor );",KS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,jS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,QS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,tb=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,eb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,nb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,ib=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,sb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,rb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,ob=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,ab=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,lb=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,cb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,hb=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,ub=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,db=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,fb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,pb=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,mb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,gb=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,_b=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,xb=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,vb=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,yb=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Sb=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,bb=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Mb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,wb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Tb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Eb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Ab=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Rb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Cb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Pb=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ib=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Lb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Db=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Nb=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Ub=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Fb=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Ob=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Bb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,kb=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,zb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Vb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Gb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Hb=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Wb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Xb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,qb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Yb=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,$b=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Zb=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Jb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Kb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,jb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Qb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,tM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,eM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,nM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,iM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,sM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,rM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,oM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,aM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,lM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,cM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,hM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,uM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,dM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,fM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,pM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,mM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,gM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,_M=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,xM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,vM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,yM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,SM=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,bM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,MM=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,wM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,TM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,EM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,AM=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,RM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,CM=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,PM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,IM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,LM=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,DM=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,NM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,UM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,FM=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,OM=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,BM=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,kM=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,zM=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,VM=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,GM=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,HM=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,WM=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,XM=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,qM=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,YM=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,$M=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,ZM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,JM=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,KM=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,jM=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,QM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,fe={alphahash_fragment:SS,alphahash_pars_fragment:bS,alphamap_fragment:MS,alphamap_pars_fragment:wS,alphatest_fragment:TS,alphatest_pars_fragment:ES,aomap_fragment:AS,aomap_pars_fragment:RS,batching_pars_vertex:CS,batching_vertex:PS,begin_vertex:IS,beginnormal_vertex:LS,bsdfs:DS,iridescence_fragment:NS,bumpmap_pars_fragment:US,clipping_planes_fragment:FS,clipping_planes_pars_fragment:OS,clipping_planes_pars_vertex:BS,clipping_planes_vertex:kS,color_fragment:zS,color_pars_fragment:VS,color_pars_vertex:GS,color_vertex:HS,common:WS,defaultnormal_vertex:XS,displacementmap_pars_vertex:qS,displacementmap_vertex:YS,emissivemap_fragment:$S,emissivemap_pars_fragment:ZS,colorspace_fragment:JS,colorspace_pars_fragment:KS,envmap_fragment:jS,envmap_common_pars_fragment:QS,envmap_pars_fragment:tb,envmap_pars_vertex:eb,envmap_physical_pars_fragment:db,envmap_vertex:nb,fog_vertex:ib,fog_pars_vertex:sb,fog_fragment:rb,fog_pars_fragment:ob,gradientmap_pars_fragment:ab,lightmap_pars_fragment:lb,lights_lambert_fragment:cb,lights_lambert_pars_fragment:hb,lights_pars_begin:ub,lights_toon_fragment:fb,lights_toon_pars_fragment:pb,lights_phong_fragment:mb,lights_phong_pars_fragment:gb,lights_physical_fragment:_b,lights_physical_pars_fragment:xb,lights_fragment_begin:vb,lights_fragment_maps:yb,lights_fragment_end:Sb,lightprobes_pars_fragment:bb,logdepthbuf_fragment:Mb,logdepthbuf_pars_fragment:wb,logdepthbuf_pars_vertex:Tb,logdepthbuf_vertex:Eb,map_fragment:Ab,map_pars_fragment:Rb,map_particle_fragment:Cb,map_particle_pars_fragment:Pb,metalnessmap_fragment:Ib,metalnessmap_pars_fragment:Lb,morphinstance_vertex:Db,morphcolor_vertex:Nb,morphnormal_vertex:Ub,morphtarget_pars_vertex:Fb,morphtarget_vertex:Ob,normal_fragment_begin:Bb,normal_fragment_maps:kb,normal_pars_fragment:zb,normal_pars_vertex:Vb,normal_vertex:Gb,normalmap_pars_fragment:Hb,clearcoat_normal_fragment_begin:Wb,clearcoat_normal_fragment_maps:Xb,clearcoat_pars_fragment:qb,iridescence_pars_fragment:Yb,opaque_fragment:$b,packing:Zb,premultiplied_alpha_fragment:Jb,project_vertex:Kb,dithering_fragment:jb,dithering_pars_fragment:Qb,roughnessmap_fragment:tM,roughnessmap_pars_fragment:eM,shadowmap_pars_fragment:nM,shadowmap_pars_vertex:iM,shadowmap_vertex:sM,shadowmask_pars_fragment:rM,skinbase_vertex:oM,skinning_pars_vertex:aM,skinning_vertex:lM,skinnormal_vertex:cM,specularmap_fragment:hM,specularmap_pars_fragment:uM,tonemapping_fragment:dM,tonemapping_pars_fragment:fM,transmission_fragment:pM,transmission_pars_fragment:mM,uv_pars_fragment:gM,uv_pars_vertex:_M,uv_vertex:xM,worldpos_vertex:vM,background_vert:yM,background_frag:SM,backgroundCube_vert:bM,backgroundCube_frag:MM,cube_vert:wM,cube_frag:TM,depth_vert:EM,depth_frag:AM,distance_vert:RM,distance_frag:CM,equirect_vert:PM,equirect_frag:IM,linedashed_vert:LM,linedashed_frag:DM,meshbasic_vert:NM,meshbasic_frag:UM,meshlambert_vert:FM,meshlambert_frag:OM,meshmatcap_vert:BM,meshmatcap_frag:kM,meshnormal_vert:zM,meshnormal_frag:VM,meshphong_vert:GM,meshphong_frag:HM,meshphysical_vert:WM,meshphysical_frag:XM,meshtoon_vert:qM,meshtoon_frag:YM,points_vert:$M,points_frag:ZM,shadow_vert:JM,shadow_frag:KM,sprite_vert:jM,sprite_frag:QM},Lt={common:{diffuse:{value:new pe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new re},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new re}},envmap:{envMap:{value:null},envMapRotation:{value:new re},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new re}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new re}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new re},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new re},normalScale:{value:new ne(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new re},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new re}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new re}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new re}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new pe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new pe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0},uvTransform:{value:new re}},sprite:{diffuse:{value:new pe(16777215)},opacity:{value:1},center:{value:new ne(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new re},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0}}},is={basic:{uniforms:Yn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.fog]),vertexShader:fe.meshbasic_vert,fragmentShader:fe.meshbasic_frag},lambert:{uniforms:Yn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new pe(0)},envMapIntensity:{value:1}}]),vertexShader:fe.meshlambert_vert,fragmentShader:fe.meshlambert_frag},phong:{uniforms:Yn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new pe(0)},specular:{value:new pe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:fe.meshphong_vert,fragmentShader:fe.meshphong_frag},standard:{uniforms:Yn([Lt.common,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.roughnessmap,Lt.metalnessmap,Lt.fog,Lt.lights,{emissive:{value:new pe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:fe.meshphysical_vert,fragmentShader:fe.meshphysical_frag},toon:{uniforms:Yn([Lt.common,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.gradientmap,Lt.fog,Lt.lights,{emissive:{value:new pe(0)}}]),vertexShader:fe.meshtoon_vert,fragmentShader:fe.meshtoon_frag},matcap:{uniforms:Yn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,{matcap:{value:null}}]),vertexShader:fe.meshmatcap_vert,fragmentShader:fe.meshmatcap_frag},points:{uniforms:Yn([Lt.points,Lt.fog]),vertexShader:fe.points_vert,fragmentShader:fe.points_frag},dashed:{uniforms:Yn([Lt.common,Lt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:fe.linedashed_vert,fragmentShader:fe.linedashed_frag},depth:{uniforms:Yn([Lt.common,Lt.displacementmap]),vertexShader:fe.depth_vert,fragmentShader:fe.depth_frag},normal:{uniforms:Yn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,{opacity:{value:1}}]),vertexShader:fe.meshnormal_vert,fragmentShader:fe.meshnormal_frag},sprite:{uniforms:Yn([Lt.sprite,Lt.fog]),vertexShader:fe.sprite_vert,fragmentShader:fe.sprite_frag},background:{uniforms:{uvTransform:{value:new re},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:fe.background_vert,fragmentShader:fe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new re}},vertexShader:fe.backgroundCube_vert,fragmentShader:fe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:fe.cube_vert,fragmentShader:fe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:fe.equirect_vert,fragmentShader:fe.equirect_frag},distance:{uniforms:Yn([Lt.common,Lt.displacementmap,{referencePosition:{value:new $},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:fe.distance_vert,fragmentShader:fe.distance_frag},shadow:{uniforms:Yn([Lt.lights,Lt.fog,{color:{value:new pe(0)},opacity:{value:1}}]),vertexShader:fe.shadow_vert,fragmentShader:fe.shadow_frag}};is.physical={uniforms:Yn([is.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new re},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new re},clearcoatNormalScale:{value:new ne(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new re},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new re},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new re},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new re},sheen:{value:0},sheenColor:{value:new pe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new re},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new re},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new re},transmissionSamplerSize:{value:new ne},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new re},attenuationDistance:{value:0},attenuationColor:{value:new pe(0)},specularColor:{value:new pe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new re},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new re},anisotropyVector:{value:new ne},anisotropyMap:{value:null},anisotropyMapTransform:{value:new re}}]),vertexShader:fe.meshphysical_vert,fragmentShader:fe.meshphysical_frag};var vh={r:0,b:0,g:0},tw=new Ae,b0=new re;b0.set(-1,0,0,0,1,0,0,0,1);function ew(i,t,e,n,s,r){let o=new pe(0),a=s===!0?0:1,c,l,h=null,d=0,u=null;function f(v){let R=v.isScene===!0?v.background:null;if(R&&R.isTexture){let S=v.backgroundBlurriness>0;R=t.get(R,S)}return R}function p(v){let R=!1,S=f(v);S===null?m(o,a):S&&S.isColor&&(m(S,1),R=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||R)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(v,R){let S=f(R);S&&S.isCubeTexture?(l===void 0&&(l=new qn(new $s(1,1,1),new ts({name:"BackgroundCubeMaterial",uniforms:Er(is.backgroundCube.uniforms),vertexShader:is.backgroundCube.vertexShader,fragmentShader:is.backgroundCube.fragmentShader,side:ni,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(C,M,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(l)),l.material.uniforms.envMap.value=S,l.material.uniforms.backgroundBlurriness.value=R.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=R.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(tw.makeRotationFromEuler(R.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(b0),l.material.toneMapped=Se.getTransfer(S.colorSpace)!==Ie,(h!==S||d!==S.version||u!==i.toneMapping)&&(l.material.needsUpdate=!0,h=S,d=S.version,u=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null)):S&&S.isTexture&&(c===void 0&&(c=new qn(new yr(2,2),new ts({name:"BackgroundMaterial",uniforms:Er(is.background.uniforms),vertexShader:is.background.vertexShader,fragmentShader:is.background.fragmentShader,side:tr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=S,c.material.uniforms.backgroundIntensity.value=R.backgroundIntensity,c.material.toneMapped=Se.getTransfer(S.colorSpace)!==Ie,S.matrixAutoUpdate===!0&&S.updateMatrix(),c.material.uniforms.uvTransform.value.copy(S.matrix),(h!==S||d!==S.version||u!==i.toneMapping)&&(c.material.needsUpdate=!0,h=S,d=S.version,u=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null))}function m(v,R){v.getRGB(vh,Od(i)),e.buffers.color.setClear(vh.r,vh.g,vh.b,R,r)}function g(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,R=1){o.set(v),a=R,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,m(o,a)},render:p,addToRenderList:y,dispose:g}}function nw(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=u(null),r=s,o=!1;function a(P,D,O,I,V){let H=!1,z=d(P,I,O,D);r!==z&&(r=z,l(r.object)),H=f(P,I,O,V),H&&p(P,I,O,V),V!==null&&t.update(V,i.ELEMENT_ARRAY_BUFFER),(H||o)&&(o=!1,S(P,D,O,I),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function c(){return i.createVertexArray()}function l(P){return i.bindVertexArray(P)}function h(P){return i.deleteVertexArray(P)}function d(P,D,O,I){let V=I.wireframe===!0,H=n[D.id];H===void 0&&(H={},n[D.id]=H);let z=P.isInstancedMesh===!0?P.id:0,ot=H[z];ot===void 0&&(ot={},H[z]=ot);let Y=ot[O.id];Y===void 0&&(Y={},ot[O.id]=Y);let J=Y[V];return J===void 0&&(J=u(c()),Y[V]=J),J}function u(P){let D=[],O=[],I=[];for(let V=0;V<e;V++)D[V]=0,O[V]=0,I[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:D,enabledAttributes:O,attributeDivisors:I,object:P,attributes:{},index:null}}function f(P,D,O,I){let V=r.attributes,H=D.attributes,z=0,ot=O.getAttributes();for(let Y in ot)if(ot[Y].location>=0){let G=V[Y],nt=H[Y];if(nt===void 0&&(Y==="instanceMatrix"&&P.instanceMatrix&&(nt=P.instanceMatrix),Y==="instanceColor"&&P.instanceColor&&(nt=P.instanceColor)),G===void 0||G.attribute!==nt||nt&&G.data!==nt.data)return!0;z++}return r.attributesNum!==z||r.index!==I}function p(P,D,O,I){let V={},H=D.attributes,z=0,ot=O.getAttributes();for(let Y in ot)if(ot[Y].location>=0){let G=H[Y];G===void 0&&(Y==="instanceMatrix"&&P.instanceMatrix&&(G=P.instanceMatrix),Y==="instanceColor"&&P.instanceColor&&(G=P.instanceColor));let nt={};nt.attribute=G,G&&G.data&&(nt.data=G.data),V[Y]=nt,z++}r.attributes=V,r.attributesNum=z,r.index=I}function y(){let P=r.newAttributes;for(let D=0,O=P.length;D<O;D++)P[D]=0}function m(P){g(P,0)}function g(P,D){let O=r.newAttributes,I=r.enabledAttributes,V=r.attributeDivisors;O[P]=1,I[P]===0&&(i.enableVertexAttribArray(P),I[P]=1),V[P]!==D&&(i.vertexAttribDivisor(P,D),V[P]=D)}function v(){let P=r.newAttributes,D=r.enabledAttributes;for(let O=0,I=D.length;O<I;O++)D[O]!==P[O]&&(i.disableVertexAttribArray(O),D[O]=0)}function R(P,D,O,I,V,H,z){z===!0?i.vertexAttribIPointer(P,D,O,V,H):i.vertexAttribPointer(P,D,O,I,V,H)}function S(P,D,O,I){y();let V=I.attributes,H=O.getAttributes(),z=D.defaultAttributeValues;for(let ot in H){let Y=H[ot];if(Y.location>=0){let J=V[ot];if(J===void 0&&(ot==="instanceMatrix"&&P.instanceMatrix&&(J=P.instanceMatrix),ot==="instanceColor"&&P.instanceColor&&(J=P.instanceColor)),J!==void 0){let G=J.normalized,nt=J.itemSize,lt=t.get(J);if(lt===void 0)continue;let j=lt.buffer,ut=lt.type,dt=lt.bytesPerElement,gt=ut===i.INT||ut===i.UNSIGNED_INT||J.gpuType===Dc;if(J.isInterleavedBufferAttribute){let pt=J.data,Dt=pt.isInterleavedBuffer===!0?pt.stride:pt.itemSize,qt=J.offset;if(pt.isInstancedInterleavedBuffer||pt.isInstancedBufferAttribute){for(let Ft=0;Ft<Y.locationSize;Ft++)g(Y.location+Ft,pt.meshPerAttribute);P.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=pt.meshPerAttribute*pt.count)}else for(let Ft=0;Ft<Y.locationSize;Ft++)m(Y.location+Ft);i.bindBuffer(i.ARRAY_BUFFER,j);for(let Ft=0;Ft<Y.locationSize;Ft++)R(Y.location+Ft,nt/Y.locationSize,ut,G,Dt*dt,(qt+nt/Y.locationSize*Ft)*dt,gt)}else{if(J.isInstancedBufferAttribute){for(let pt=0;pt<Y.locationSize;pt++)g(Y.location+pt,J.meshPerAttribute);P.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let pt=0;pt<Y.locationSize;pt++)m(Y.location+pt);i.bindBuffer(i.ARRAY_BUFFER,j);for(let pt=0;pt<Y.locationSize;pt++)R(Y.location+pt,nt/Y.locationSize,ut,G,nt*dt,nt/Y.locationSize*pt*dt,gt)}}else if(z!==void 0){let G=z[ot];if(G!==void 0)switch(G.length){case 2:i.vertexAttrib2fv(Y.location,G);break;case 3:i.vertexAttrib3fv(Y.location,G);break;case 4:i.vertexAttrib4fv(Y.location,G);break;default:i.vertexAttrib1fv(Y.location,G)}}}}v()}function C(){F();for(let P in n){let D=n[P];for(let O in D){let I=D[O];for(let V in I){let H=I[V];for(let z in H)h(H[z].object),delete H[z];delete I[V]}}delete n[P]}}function M(P){if(n[P.id]===void 0)return;let D=n[P.id];for(let O in D){let I=D[O];for(let V in I){let H=I[V];for(let z in H)h(H[z].object),delete H[z];delete I[V]}}delete n[P.id]}function _(P){for(let D in n){let O=n[D];for(let I in O){let V=O[I];if(V[P.id]===void 0)continue;let H=V[P.id];for(let z in H)h(H[z].object),delete H[z];delete V[P.id]}}}function b(P){for(let D in n){let O=n[D],I=P.isInstancedMesh===!0?P.id:0,V=O[I];if(V!==void 0){for(let H in V){let z=V[H];for(let ot in z)h(z[ot].object),delete z[ot];delete V[H]}delete O[I],Object.keys(O).length===0&&delete n[D]}}}function F(){A(),o=!0,r!==s&&(r=s,l(r.object))}function A(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:F,resetDefaultState:A,dispose:C,releaseStatesOfGeometry:M,releaseStatesOfObject:b,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:m,disableUnusedAttributes:v}}function iw(i,t,e){let n;function s(c){n=c}function r(c,l){i.drawArrays(n,c,l),e.update(l,n,1)}function o(c,l,h){h!==0&&(i.drawArraysInstanced(n,c,l,h),e.update(l,n,h))}function a(c,l,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,l,0,h);let u=0;for(let f=0;f<h;f++)u+=l[f];e.update(u,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function sw(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==yi&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let b=_===Vi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==oi&&_!==Ri&&!b&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function c(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",h=c(l);h!==l&&(Jt("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let d=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=e.logarithmicDepthBuffer===!0&&d===!1;e.reversedDepthBuffer===!0&&d===!1&&Jt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&d===!0&&Jt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),R=i.getParameter(i.MAX_VARYING_VECTORS),S=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),M=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:p,maxTextureSize:y,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:v,maxVaryings:R,maxFragmentUniforms:S,maxSamples:C,samples:M}}function rw(i){let t=this,e=null,n=0,s=!1,r=!1,o=new _i,a=new re,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let f=d.length!==0||u||n!==0||s;return s=u,n=d.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){e=h(d,u,0)},this.setState=function(d,u,f){let p=d.clippingPlanes,y=d.clipIntersection,m=d.clipShadows,g=i.get(d);if(!s||p===null||p.length===0||r&&!m)r?h(null):l();else{let v=r?0:n,R=v*4,S=g.clippingState||null;c.value=S,S=h(p,u,R,f);for(let C=0;C!==R;++C)S[C]=e[C];g.clippingState=S,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(d,u,f,p){let y=d!==null?d.length:0,m=null;if(y!==0){if(m=c.value,p!==!0||m===null){let g=f+y*4,v=u.matrixWorldInverse;a.getNormalMatrix(v),(m===null||m.length<g)&&(m=new Float32Array(g));for(let R=0,S=f;R!==y;++R,S+=4)o.copy(d[R]).applyMatrix4(v,a),o.normal.toArray(m,S),m[S+3]=o.constant}c.value=m,c.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,m}}var Wa=class extends xi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new ba(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new $s(5,5,5),r=new ts({name:"CubemapFromEquirect",uniforms:Er(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ni,blending:br});r.uniforms.tEquirect.value=e;let o=new qn(s,r),a=e.minFilter;return e.minFilter===As&&(e.minFilter=Un),new Eo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},t0=256,ow=3,aw=20,M0=256,w0=16,lw=3,cw=new $,hw=new pe,Sh=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Eo(1,10,null),this._boxMesh=new qn(new $s(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=cw}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let d=c.autoClear,u=c.autoClearColor,f=c.autoClearDepth,p=c.autoClearStencil,y=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,y===null&&(t.background=c.getClearColor(hw));let m=new Eo(n,s,h);return m.position.copy(a),m.update(c,t),c.autoClear=d,c.autoClearColor=u,c.autoClearDepth=f,c.autoClearStencil=p,t.background=y,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=i0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=n0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(t0,Ud(t))}_fromTexture(t,e){t.mapping===wr||t.mapping===Po?this._setSize(t.image.length===0?t0:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=e0(t,!1,!1),n=Math.log2(t)-ow;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=e0(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===wr||t.mapping===Po?(this._cubemapMaterial===null&&(this._cubemapMaterial=i0()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=n0()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=uw(),this._integrationMaterial=dw());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/w0);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-lw)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let c=a>0?Math.log2(e)+.5*Math.log2(6/(M0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=fw());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function e0(i,t,e){return new Wa(i,{minFilter:As,generateMipmaps:t,type:Vi,colorSpace:da,depthBuffer:e})}function Xa(i,t,e){return new ts({name:i,uniforms:t,vertexShader:fe.cube_vert,fragmentShader:e,side:ni,blending:br,depthTest:!1,depthWrite:!1})}function uw(){return Xa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${M0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function dw(){return Xa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:w0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function fw(){return Xa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${aw}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function n0(){return Xa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function i0(){return Xa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function pw(i){let t=new WeakMap,e=new WeakMap,n=null;function s(u,f=!1){return u==null?null:f?o(u):r(u)}function r(u){if(u&&u.isTexture){let f=u.mapping;if(f===Pc||f===Ic)if(t.has(u)){let p=t.get(u).texture;return a(p,u.mapping)}else{let p=u.image;if(p&&p.height>0){let y=new Wa(p.height);return y.fromEquirectangularTexture(i,u),t.set(u,y),u.addEventListener("dispose",l),a(y.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let f=u.mapping,p=f===Pc||f===Ic,y=f===wr||f===Po;if(p||y){let m=e.get(u),g=m!==void 0?m.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==g)return n===null&&(n=new Sh(i)),m=p?n.fromEquirectangular(u,m):n.fromCubemap(u,m),m.texture.pmremVersion=u.pmremVersion,e.set(u,m),m.texture;if(m!==void 0)return m.texture;{let v=u.image;return p&&v&&v.height>0||y&&v&&c(v)?(n===null&&(n=new Sh(i)),m=p?n.fromEquirectangular(u):n.fromCubemap(u),m.texture.pmremVersion=u.pmremVersion,e.set(u,m),u.addEventListener("dispose",h),m.texture):null}}}return u}function a(u,f){return f===Pc?u.mapping=wr:f===Ic&&(u.mapping=Po),u}function c(u){let f=0,p=6;for(let y=0;y<p;y++)u[y]!==void 0&&f++;return f===p}function l(u){let f=u.target;f.removeEventListener("dispose",l);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(u){let f=u.target;f.removeEventListener("dispose",h);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function d(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:d}}function mw(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&ca("WebGLRenderer: "+n+" extension not supported."),s}}}function gw(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){c(p.target)}function c(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let y=r.get(p);y&&(t.remove(y),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function l(p,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function h(p){let y=p.attributes;for(let m in y)t.update(y[m],i.ARRAY_BUFFER)}function d(p){let y=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let v=y!==null?y.array.length:m.array.length/3-1,R=m.count>=65535?va:xa,S=new R(Math.ceil(v/3)*6,1),C=S.array;if(y!==null){let _=y.array;g=y.version;for(let b=0,F=0;b<v;b+=3){let A=_[b+0],P=_[b+1],D=_[b+2];C[F++]=A,C[F++]=P,C[F++]=P,C[F++]=D,C[F++]=D,C[F++]=A}}else{g=m.version;for(let _=0,b=0;_<v;_+=3){let F=_+0,A=_+1,P=_+2;C[b++]=F,C[b++]=A,C[b++]=A,C[b++]=P,C[b++]=P,C[b++]=F}}S.version=g;let M=r.get(p);M&&t.remove(M),r.set(p,S)}function u(p){let y=r.get(p);if(y){let m=p.index;m!==null&&y.version<m.version&&d(p)}else d(p);return r.get(p)}function f(){for(let p in s){let y=s[p].deref();y!==void 0&&c(y)}}return{get:l,update:h,getWireframeAttribute:u,dispose:f}}function _w(i,t,e){let n;function s(d){n=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function c(d,u){i.drawElements(n,u,r,d*o),e.update(u,n,1)}function l(d,u,f){f!==0&&(i.drawElementsInstanced(n,u,r,d*o,f),e.update(u,n,f))}function h(d,u,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,u,0,r,d,0,f);let y=0;for(let m=0;m<f;m++)y+=u[m];e.update(y,n,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function xw(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:se("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function vw(i,t,e){let n=new WeakMap,s=new Ze;function r(o,a,c){let l=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,u=n.get(a);if(u===void 0||u.count!==d){let F=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",F)};u!==void 0&&u.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],R=0;f===!0&&(R=1),p===!0&&(R=2),y===!0&&(R=3);let S=a.attributes.position.count*R,C=1;S>t.maxTextureSize&&(C=Math.ceil(S/t.maxTextureSize),S=t.maxTextureSize);let M=new Float32Array(S*C*4*d),_=new ma(M,S,C,d);_.type=Ri,_.needsUpdate=!0;let b=R*4;for(let A=0;A<d;A++){let P=m[A],D=g[A],O=v[A],I=S*C*4*A;for(let V=0;V<P.count;V++){let H=V*b;f===!0&&(s.fromBufferAttribute(P,V),M[I+H+0]=s.x,M[I+H+1]=s.y,M[I+H+2]=s.z,M[I+H+3]=0),p===!0&&(s.fromBufferAttribute(D,V),M[I+H+4]=s.x,M[I+H+5]=s.y,M[I+H+6]=s.z,M[I+H+7]=0),y===!0&&(s.fromBufferAttribute(O,V),M[I+H+8]=s.x,M[I+H+9]=s.y,M[I+H+10]=s.z,M[I+H+11]=O.itemSize===4?s.w:1)}}u={count:d,texture:_,size:new ne(S,C)},n.set(a,u),a.addEventListener("dispose",F)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let f=0;for(let y=0;y<l.length;y++)f+=l[y];let p=a.morphTargetsRelative?1:1-f;c.getUniforms().setValue(i,"morphTargetBaseInfluence",p),c.getUniforms().setValue(i,"morphTargetInfluences",l)}c.getUniforms().setValue(i,"morphTargetsTexture",u.texture,e),c.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:r}}function yw(i,t,e,n,s){let r=new WeakMap;function o(l){let h=s.render.frame,d=l.geometry,u=t.get(l,d);if(r.get(u)!==h&&(t.update(u),r.set(u,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let f=l.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return u}function a(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var Sw={[md]:"LINEAR_TONE_MAPPING",[gd]:"REINHARD_TONE_MAPPING",[_d]:"CINEON_TONE_MAPPING",[xd]:"ACES_FILMIC_TONE_MAPPING",[yd]:"AGX_TONE_MAPPING",[Sd]:"NEUTRAL_TONE_MAPPING",[vd]:"CUSTOM_TONE_MAPPING"};function bw(i,t,e,n,s,r){let o=new xi(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,h=new Fn;h.setAttribute("position",new xn([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new xn([0,2,0,0,2,0],2));let d=new pc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new qn(h,d),f=new Pa(-1,1,1,-1,0,1),p=null,y=null,m=!1,g,v=null,R=[],S=!1;this.setSize=function(C,M){o.setSize(C,M),a!==null&&a.setSize(C,M),c!==null&&c.setSize(C,M);for(let _=0;_<R.length;_++){let b=R[_];b.setSize&&b.setSize(C,M)}},this.setEffects=function(C){R=C,S=R.length>0&&R[0].isRenderPass===!0;let M=o.width,_=o.height;R.length>0&&a===null&&(a=new xi(M,_,{type:Vi,depthBuffer:!1,stencilBuffer:!1}),c=new xi(M,_,{type:Vi,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&R.some(F=>F.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&l===null&&(l=new Es(M,_),r===!0&&(l.format=Rs,l.type=Tr)),o.dispose(),o.depthTexture=b?l:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let F=0;F<R.length;F++){let A=R[F];A.setSize&&A.setSize(M,_),b&&A.needsDepthTexture===!0&&A.setDepthTexture&&A.setDepthTexture(l)}},this.begin=function(C,M){if(m||C.toneMapping===es&&R.length===0)return!1;if(v=M,M!==null){let _=M.width,b=M.height;(o.width!==_||o.height!==b)&&this.setSize(_,b)}return S===!1&&C.setRenderTarget(o),g=C.toneMapping,C.toneMapping=es,!0},this.hasRenderPass=function(){return S},this.end=function(C,M){C.toneMapping=g,m=!0;let _=o,b=a;for(let F=0;F<R.length;F++){let A=R[F];A.enabled!==!1&&(A.render(C,b,_,M),A.needsSwap!==!1&&(_=b,b=b===a?c:a))}if(p!==C.outputColorSpace||y!==C.toneMapping){p=C.outputColorSpace,y=C.toneMapping,d.defines={},Se.getTransfer(p)===Ie&&(d.defines.SRGB_TRANSFER="");let F=Sw[y];F&&(d.defines[F]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=_.texture,C.setRenderTarget(v),C.render(u,f),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),h.dispose(),d.dispose()}}var T0=new si,E0=new Es(1,1),A0=new Ma(1),R0=new ma,C0=new cc,P0=new ba,s0=[],r0=[],o0=new Float32Array(16),a0=new Float32Array(9),l0=new Float32Array(4);function No(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=s0[s];if(r===void 0&&(r=new Float32Array(s),s0[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function vn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function yn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Mh(i,t){let e=r0[t];e===void 0&&(e=new Int32Array(t),r0[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function Mw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function ww(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vn(e,t))return;i.uniform2fv(this.addr,t),yn(e,t)}}function Tw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(vn(e,t))return;i.uniform3fv(this.addr,t),yn(e,t)}}function Ew(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vn(e,t))return;i.uniform4fv(this.addr,t),yn(e,t)}}function Aw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(vn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),yn(e,t)}else{if(vn(e,n))return;l0.set(n),i.uniformMatrix2fv(this.addr,!1,l0),yn(e,n)}}function Rw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(vn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),yn(e,t)}else{if(vn(e,n))return;a0.set(n),i.uniformMatrix3fv(this.addr,!1,a0),yn(e,n)}}function Cw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(vn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),yn(e,t)}else{if(vn(e,n))return;o0.set(n),i.uniformMatrix4fv(this.addr,!1,o0),yn(e,n)}}function Pw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function Iw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vn(e,t))return;i.uniform2iv(this.addr,t),yn(e,t)}}function Lw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(vn(e,t))return;i.uniform3iv(this.addr,t),yn(e,t)}}function Dw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vn(e,t))return;i.uniform4iv(this.addr,t),yn(e,t)}}function Nw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function Uw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vn(e,t))return;i.uniform2uiv(this.addr,t),yn(e,t)}}function Fw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(vn(e,t))return;i.uniform3uiv(this.addr,t),yn(e,t)}}function Ow(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vn(e,t))return;i.uniform4uiv(this.addr,t),yn(e,t)}}function wh(i){return i.version===0&&(i.compareFunction=Id,i.needsUpdate=!0),i}function Bw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=wh(E0):r=T0,e.setTexture2D(t||r,s)}function kw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||C0,s)}function zw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=wh(A0):r=P0,e.setTextureCube(t||r,s)}function Vw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||R0,s)}function Gw(i){switch(i){case 5126:return Mw;case 35664:return ww;case 35665:return Tw;case 35666:return Ew;case 35674:return Aw;case 35675:return Rw;case 35676:return Cw;case 5124:case 35670:return Pw;case 35667:case 35671:return Iw;case 35668:case 35672:return Lw;case 35669:case 35673:return Dw;case 5125:return Nw;case 36294:return Uw;case 36295:return Fw;case 36296:return Ow;case 35678:case 36198:case 36298:case 36306:case 35682:return Bw;case 35679:case 36299:case 36307:return kw;case 35680:case 36300:case 36308:case 36293:return zw;case 36289:case 36303:case 36311:case 36292:return Vw}}function Hw(i,t){i.uniform1fv(this.addr,t)}function Ww(i,t){let e=No(t,this.size,2);i.uniform2fv(this.addr,e)}function Xw(i,t){let e=No(t,this.size,3);i.uniform3fv(this.addr,e)}function qw(i,t){let e=No(t,this.size,4);i.uniform4fv(this.addr,e)}function Yw(i,t){let e=No(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function $w(i,t){let e=No(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function Zw(i,t){let e=No(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function Jw(i,t){i.uniform1iv(this.addr,t)}function Kw(i,t){i.uniform2iv(this.addr,t)}function jw(i,t){i.uniform3iv(this.addr,t)}function Qw(i,t){i.uniform4iv(this.addr,t)}function t1(i,t){i.uniform1uiv(this.addr,t)}function e1(i,t){i.uniform2uiv(this.addr,t)}function n1(i,t){i.uniform3uiv(this.addr,t)}function i1(i,t){i.uniform4uiv(this.addr,t)}function s1(i,t,e){let n=this.cache,s=t.length,r=Mh(e,s);vn(n,r)||(i.uniform1iv(this.addr,r),yn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=wh(E0):o=T0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function r1(i,t,e){let n=this.cache,s=t.length,r=Mh(e,s);vn(n,r)||(i.uniform1iv(this.addr,r),yn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||C0,r[o])}function o1(i,t,e){let n=this.cache,s=t.length,r=Mh(e,s);vn(n,r)||(i.uniform1iv(this.addr,r),yn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=wh(A0):o=P0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function a1(i,t,e){let n=this.cache,s=t.length,r=Mh(e,s);vn(n,r)||(i.uniform1iv(this.addr,r),yn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||R0,r[o])}function l1(i){switch(i){case 5126:return Hw;case 35664:return Ww;case 35665:return Xw;case 35666:return qw;case 35674:return Yw;case 35675:return $w;case 35676:return Zw;case 5124:case 35670:return Jw;case 35667:case 35671:return Kw;case 35668:case 35672:return jw;case 35669:case 35673:return Qw;case 5125:return t1;case 36294:return e1;case 36295:return n1;case 36296:return i1;case 35678:case 36198:case 36298:case 36306:case 35682:return s1;case 35679:case 36299:case 36307:return r1;case 35680:case 36300:case 36308:case 36293:return o1;case 36289:case 36303:case 36311:case 36292:return a1}}var Hd=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=Gw(e.type)}},Wd=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=l1(e.type)}},Xd=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},Vd=/(\w+)(\])?(\[|\.)?/g;function c0(i,t){i.seq.push(t),i.map[t.id]=t}function c1(i,t,e){let n=i.name,s=n.length;for(Vd.lastIndex=0;;){let r=Vd.exec(n),o=Vd.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){c0(e,l===void 0?new Hd(a,i,t):new Wd(a,i,t));break}else{let d=e.map[a];d===void 0&&(d=new Xd(a),c0(e,d)),e=d}}}var Do=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),c=t.getUniformLocation(e,a.name);c1(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],c=n[a.id];c.needsUpdate!==!1&&a.setValue(t,c.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function h0(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var h1=37297,u1=0;function d1(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var u0=new re;function f1(i){Se._getMatrix(u0,Se.workingColorSpace,i);let t=`mat3( ${u0.elements.map(e=>e.toFixed(4))} )`;switch(Se.getTransfer(i)){case fa:return[t,"LinearTransferOETF"];case Ie:return[t,"sRGBTransferOETF"];default:return Jt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function d0(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+d1(i.getShaderSource(t),a)}else return r}function p1(i,t){let e=f1(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var m1={[md]:"Linear",[gd]:"Reinhard",[_d]:"Cineon",[xd]:"ACESFilmic",[yd]:"AgX",[Sd]:"Neutral",[vd]:"Custom"};function g1(i,t){let e=m1[t];return e===void 0?(Jt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var yh=new $;function _1(){Se.getLuminanceCoefficients(yh);let i=yh.x.toFixed(4),t=yh.y.toFixed(4),e=yh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function x1(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ha).join(`
`)}function v1(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function y1(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Ha(i){return i!==""}function f0(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function p0(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var S1=/^[ \t]*#include +<([\w\d./]+)>/gm;function qd(i){return i.replace(S1,b1)}function b1(i,t){let e=fe[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return qd(e)}var M1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function m0(i){return i.replace(M1,w1)}function w1(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function g0(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var T1={[Na]:"SHADOWMAP_TYPE_PCF",[Ro]:"SHADOWMAP_TYPE_VSM"};function E1(i){return T1[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var A1={[Po]:"ENVMAP_MODE_REFRACTION"};function R1(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":A1[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var C1={[Cc]:"ENVMAP_BLENDING_MULTIPLY",[Lg]:"ENVMAP_BLENDING_MIX",[Dg]:"ENVMAP_BLENDING_ADD"};function P1(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":C1[i.combine]||"ENVMAP_BLENDING_NONE"}function I1(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,c=E1(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=R1(e),d=P1(e),u=x1(e),f=v1(r),p=s.createProgram(),y,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Ha).join(`
`),y.length>0&&(y+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Ha).join(`
`),m.length>0&&(m+=`
`)):(y=[g0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ha).join(`
`),m=[g0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+h:"",e.envMap?"#define "+d:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==es?"#define TONE_MAPPING":"",e.toneMapping!==es?fe.tonemapping_pars_fragment:"",e.toneMapping!==es?g1("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",fe.colorspace_pars_fragment,p1("linearToOutputTexel",e.outputColorSpace),_1(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Ha).join(`
`)),o=qd(o),o=f0(o,e),o=p0(o,e),a=qd(a),a=f0(a,e),a=p0(a,e),o=m0(o),a=m0(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,y=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,m=["#define varying in",e.glslVersion===Ld?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Ld?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=g+y+o,R=g+m+a,S=h0(s,s.VERTEX_SHADER,v),C=h0(s,s.FRAGMENT_SHADER,R);s.attachShader(p,S),s.attachShader(p,C),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function M(A){if(i.debug.checkShaderErrors){let P=s.getProgramInfoLog(p)||"",D=s.getShaderInfoLog(S)||"",O=s.getShaderInfoLog(C)||"",I=P.trim(),V=D.trim(),H=O.trim(),z=!0,ot=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(z=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,S,C);else{let Y=d0(s,S,"vertex"),J=d0(s,C,"fragment");se("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+A.name+`
Material Type: `+A.type+`

Program Info Log: `+I+`
`+Y+`
`+J)}else I!==""?Jt("WebGLProgram: Program Info Log:",I):(V===""||H==="")&&(ot=!1);ot&&(A.diagnostics={runnable:z,programLog:I,vertexShader:{log:V,prefix:y},fragmentShader:{log:H,prefix:m}})}s.deleteShader(S),s.deleteShader(C),_=new Do(s,p),b=y1(s,p)}let _;this.getUniforms=function(){return _===void 0&&M(this),_};let b;this.getAttributes=function(){return b===void 0&&M(this),b};let F=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return F===!1&&(F=s.getProgramParameter(p,h1)),F},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=u1++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=S,this.fragmentShader=C,this}var L1=0,Yd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new $d(t),e.set(t,n)),n}},$d=class{constructor(t){this.id=L1++,this.code=t,this.usedTimes=0}};function D1(i){return i===er||i===za||i===Va}function N1(i,t,e,n,s,r){let o=new ga,a=new Yd,c=new Set,l=[],h=new Map,d=n.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return c.add(_),_===0?"uv":`uv${_}`}function p(_,b,F,A,P,D){let O=A.fog,I=P.geometry,V=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?A.environment:null,H=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,z=t.get(_.envMap||V,H),ot=u[_.type],Y=n.precision;_.precision!==null&&(Y=n.getMaxPrecision(_.precision),Y!==_.precision&&Jt("WebGLProgram.getParameters:",_.precision,"not supported, using",Y,"instead."));let J=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,G=J!==void 0?J.length:0,nt=0;I.morphAttributes.position!==void 0&&(nt=1),I.morphAttributes.normal!==void 0&&(nt=2),I.morphAttributes.color!==void 0&&(nt=3);let lt,j,ut,dt;if(ot){let Rt=is[ot];lt=Rt.vertexShader,j=Rt.fragmentShader}else{lt=_.vertexShader,j=_.fragmentShader;let Rt=a.getVertexShaderStage(_),ue=a.getFragmentShaderStage(_);a.update(_,Rt,ue),ut=Rt.id,dt=ue.id}let gt=i.getRenderTarget(),pt=i.state.buffers.depth.getReversed(),Dt=P.isInstancedMesh===!0,qt=P.isBatchedMesh===!0,Ft=!!_.map,oe=!!_.matcap,he=!!z,Qt=he&&z.isPMREMTexture===!0,Ve=!!_.aoMap,Ce=!!_.lightMap,Ke=!!_.bumpMap&&_.wireframe===!1,Ue=!!_.normalMap,bn=!!_.displacementMap,be=!!_.emissiveMap,pn=!!_.metalnessMap,je=!!_.roughnessMap,an=_.anisotropy>0,k=_.clearcoat>0,Ct=_.diffuseRoughness>0,Kt=_.dispersion>0,ce=_.retroreflectivity>0,wt=_.iridescence>0,Oe=_.sheen>0,Wt=_.transmission>0,Zt=an&&!!_.anisotropyMap,L=k&&!!_.clearcoatMap,w=k&&!!_.clearcoatNormalMap,Z=k&&!!_.clearcoatRoughnessMap,mt=Ct&&!!_.diffuseRoughnessMap,ct=wt&&!!_.iridescenceMap,yt=wt&&!!_.iridescenceThicknessMap,St=Oe&&!!_.sheenColorMap,it=Oe&&!!_.sheenRoughnessMap,rt=!!_.specularMap,xt=!!_.specularColorMap,B=!!_.specularIntensityMap,at=Wt&&!!_.transmissionMap,st=Wt&&!!_.thicknessMap,Tt=!!_.gradientMap,vt=!!_.alphaMap,Mt=_.alphaTest>0,Xt=!!_.alphaHash,te=!!_.extensions,ft=es;_.toneMapped&&(gt===null||gt.isXRRenderTarget===!0)&&(ft=i.toneMapping);let kt=Qt?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,ee={shaderID:ot,shaderType:_.type,shaderName:_.name,vertexShader:lt,fragmentShader:j,defines:_.defines,customVertexShaderID:ut,customFragmentShaderID:dt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:Y,batching:qt,batchingColor:qt&&P._colorsTexture!==null,instancing:Dt,instancingColor:Dt&&P.instanceColor!==null,instancingMorph:Dt&&P.morphTexture!==null,outputColorSpace:gt===null?i.outputColorSpace:gt.isXRRenderTarget===!0?gt.texture.colorSpace:Se.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Ft,matcap:oe,envMap:he,envMapMode:he&&z.mapping,envMapPMREM:Qt,envMapMaxLod:Qt?kt.length-1:null,envMapSize:Qt?kt[0].width:null,aoMap:Ve,lightMap:Ce,bumpMap:Ke,normalMap:Ue,displacementMap:bn,emissiveMap:be,normalMapObjectSpace:Ue&&_.normalMapType===Fg,normalMapTangentSpace:Ue&&_.normalMapType===gh,packedNormalMap:Ue&&_.normalMapType===gh&&D1(_.normalMap.format),metalnessMap:pn,roughnessMap:je,anisotropy:an,anisotropyMap:Zt,clearcoat:k,clearcoatMap:L,clearcoatNormalMap:w,clearcoatRoughnessMap:Z,diffuseRoughness:Ct,diffuseRoughnessMap:mt,dispersion:Kt,retroreflection:ce,iridescence:wt,iridescenceMap:ct,iridescenceThicknessMap:yt,sheen:Oe,sheenColorMap:St,sheenRoughnessMap:it,specularMap:rt,specularColorMap:xt,specularIntensityMap:B,transmission:Wt,transmissionMap:at,thicknessMap:st,gradientMap:Tt,opaque:_.transparent===!1&&_.blending===Co&&_.alphaToCoverage===!1,alphaMap:vt,alphaTest:Mt,alphaHash:Xt,combine:_.combine,mapUv:Ft&&f(_.map.channel),aoMapUv:Ve&&f(_.aoMap.channel),lightMapUv:Ce&&f(_.lightMap.channel),bumpMapUv:Ke&&f(_.bumpMap.channel),normalMapUv:Ue&&f(_.normalMap.channel),displacementMapUv:bn&&f(_.displacementMap.channel),emissiveMapUv:be&&f(_.emissiveMap.channel),metalnessMapUv:pn&&f(_.metalnessMap.channel),roughnessMapUv:je&&f(_.roughnessMap.channel),anisotropyMapUv:Zt&&f(_.anisotropyMap.channel),clearcoatMapUv:L&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:w&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Z&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:mt&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:ct&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:yt&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:St&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:it&&f(_.sheenRoughnessMap.channel),specularMapUv:rt&&f(_.specularMap.channel),specularColorMapUv:xt&&f(_.specularColorMap.channel),specularIntensityMapUv:B&&f(_.specularIntensityMap.channel),transmissionMapUv:at&&f(_.transmissionMap.channel),thicknessMapUv:st&&f(_.thicknessMap.channel),alphaMapUv:vt&&f(_.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Ue||an),vertexNormals:!!I.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:P.isPoints===!0&&!!I.attributes.uv&&(Ft||vt),fog:!!O,useFog:_.fog===!0,fogExp2:!!O&&O.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||I.attributes.normal===void 0&&Ue===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:pt,skinning:P.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:G,morphTextureStride:nt,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:D.filter(Rt=>Rt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&F.length>0,shadowMapType:i.shadowMap.type,toneMapping:ft,decodeVideoTexture:Ft&&_.map.isVideoTexture===!0&&Se.getTransfer(_.map.colorSpace)===Ie,decodeVideoTextureEmissive:be&&_.emissiveMap.isVideoTexture===!0&&Se.getTransfer(_.emissiveMap.colorSpace)===Ie,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===ri,flipSided:_.side===ni,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:te&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(te&&_.extensions.multiDraw===!0||qt)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return ee.vertexUv1s=c.has(1),ee.vertexUv2s=c.has(2),ee.vertexUv3s=c.has(3),c.clear(),ee}function y(_){let b=[];if(_.shaderID?b.push(_.shaderID):(b.push(_.customVertexShaderID),b.push(_.customFragmentShaderID)),_.defines!==void 0)for(let F in _.defines)b.push(F),b.push(_.defines[F]);return _.isRawShaderMaterial===!1&&(m(b,_),g(b,_),b.push(i.outputColorSpace)),b.push(_.customProgramCacheKey),b.join()}function m(_,b){_.push(b.precision),_.push(b.outputColorSpace),_.push(b.envMapMode),_.push(b.envMapPMREM),_.push(b.envMapMaxLod),_.push(b.envMapSize),_.push(b.mapUv),_.push(b.alphaMapUv),_.push(b.lightMapUv),_.push(b.aoMapUv),_.push(b.bumpMapUv),_.push(b.normalMapUv),_.push(b.displacementMapUv),_.push(b.emissiveMapUv),_.push(b.metalnessMapUv),_.push(b.roughnessMapUv),_.push(b.anisotropyMapUv),_.push(b.clearcoatMapUv),_.push(b.clearcoatNormalMapUv),_.push(b.clearcoatRoughnessMapUv),_.push(b.diffuseRoughnessMapUv),_.push(b.iridescenceMapUv),_.push(b.iridescenceThicknessMapUv),_.push(b.sheenColorMapUv),_.push(b.sheenRoughnessMapUv),_.push(b.specularMapUv),_.push(b.specularColorMapUv),_.push(b.specularIntensityMapUv),_.push(b.transmissionMapUv),_.push(b.thicknessMapUv),_.push(b.combine),_.push(b.fogExp2),_.push(b.sizeAttenuation),_.push(b.morphTargetsCount),_.push(b.numSunLights),_.push(b.numDirLights),_.push(b.numPointLights),_.push(b.numSpotLights),_.push(b.numSpotLightMaps),_.push(b.numHemiLights),_.push(b.numRectAreaLights),_.push(b.numSunLightShadows),_.push(b.numDirLightShadows),_.push(b.numPointLightShadows),_.push(b.numSpotLightShadows),_.push(b.numSpotLightShadowsWithMaps),_.push(b.numLightProbes),_.push(b.numLightProbeGrids),_.push(b.shadowMapType),_.push(b.toneMapping),_.push(b.numClippingPlanes),_.push(b.numClipIntersection),_.push(b.depthPacking)}function g(_,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function v(_){let b=u[_.type],F;if(b){let A=is[b];F=Kg.clone(A.uniforms)}else F=_.uniforms;return F}function R(_,b){let F=h.get(b);return F!==void 0?++F.usedTimes:(F=new I1(i,b,_,s),l.push(F),h.set(b,F)),F}function S(_){if(--_.usedTimes===0){let b=l.indexOf(_);l[b]=l[l.length-1],l.pop(),h.delete(_.cacheKey),_.destroy()}}function C(_){a.remove(_)}function M(){a.dispose()}return{getParameters:p,getProgramCacheKey:y,getUniforms:v,acquireProgram:R,releaseProgram:S,releaseShaderCache:C,programs:l,dispose:M}}function U1(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,c){i.get(o)[a]=c}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function F1(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function _0(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function x0(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(u){let f=0;return u.isInstancedMesh&&(f+=2),u.isSkinnedMesh&&(f+=1),f}function a(u,f,p,y,m,g){let v=i[t];return v===void 0?(v={id:u.id,object:u,geometry:f,material:p,materialVariant:o(u),groupOrder:y,renderOrder:u.renderOrder,z:m,group:g},i[t]=v):(v.id=u.id,v.object=u,v.geometry=f,v.material=p,v.materialVariant=o(u),v.groupOrder=y,v.renderOrder=u.renderOrder,v.z=m,v.group=g),t++,v}function c(u,f,p,y,m,g,v){v.reversedDepth===!0&&(m=-m);let R=a(u,f,p,y,m,g);p.transmission>0?n.push(R):p.transparent===!0?s.push(R):e.push(R)}function l(u,f,p,y,m,g){let v=a(u,f,p,y,m,g);p.transmission>0?n.unshift(v):p.transparent===!0?s.unshift(v):e.unshift(v)}function h(u,f){e.length>1&&e.sort(u||F1),n.length>1&&n.sort(f||_0),s.length>1&&s.sort(f||_0)}function d(){for(let u=t,f=i.length;u<f;u++){let p=i[u];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:c,unshift:l,finish:d,sort:h}}function O1(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new x0,i.set(n,[o])):s>=r.length?(o=new x0,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function B1(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new $,color:new pe};break;case"SpotLight":e={position:new $,direction:new $,color:new pe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new $,color:new pe,distance:0,decay:0};break;case"HemisphereLight":e={direction:new $,skyColor:new pe,groundColor:new pe};break;case"RectAreaLight":e={color:new pe,position:new $,halfWidth:new $,halfHeight:new $};break}return i[t.id]=e,e}}}function k1(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ne};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ne};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ne,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var z1=0;function V1(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function G1(i){let t=new B1,e=k1(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new $);let s=new $,r=new Ae,o=new Ae;function a(l){let h=0,d=0,u=0;for(let D=0;D<9;D++)n.probe[D].set(0,0,0);let f=0,p=0,y=0,m=0,g=0,v=0,R=0,S=0,C=0,M=0,_=0,b=0,F=0,A=0;l.sort(V1);for(let D=0,O=l.length;D<O;D++){let I=l[D],V=I.color,H=I.intensity,z=I.distance,ot=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===er?ot=I.shadow.map.texture:ot=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=V.r*H,d+=V.g*H,u+=V.b*H;else if(I.isLightProbe){for(let Y=0;Y<9;Y++)n.probe[Y].addScaledVector(I.sh.coefficients[Y],H);A++}else if(I.isSunLight){let Y=t.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let J=I.shadow,G=e.get(I);G.shadowIntensity=J.intensity,G.shadowBias=J.bias,G.shadowNormalBias=J.normalBias,G.shadowRadius=J.radius,G.shadowMapSize.copy(J.mapSize).multiply(J.getFrameExtents()),n.sunShadow[p]=G,n.sunShadowMap[p]=ot;let nt=J.getViewportCount();for(let lt=0;lt<nt;lt++)n.sunShadowMatrix[y+lt]=J.getMatrix(lt),n.sunShadowCascade[y+lt]=J._cascadeData[lt];y+=nt,p++}n.sun[f]=Y,f++}else if(I.isDirectionalLight){let Y=t.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let J=I.shadow,G=e.get(I);G.shadowIntensity=J.intensity,G.shadowBias=J.bias,G.shadowNormalBias=J.normalBias,G.shadowRadius=J.radius,G.shadowMapSize=J.mapSize,n.directionalShadow[m]=G,n.directionalShadowMap[m]=ot,n.directionalShadowMatrix[m]=I.shadow.matrix,C++}n.directional[m]=Y,m++}else if(I.isSpotLight){let Y=t.get(I);Y.position.setFromMatrixPosition(I.matrixWorld),Y.color.copy(V).multiplyScalar(H),Y.distance=z,Y.coneCos=Math.cos(I.angle),Y.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),Y.decay=I.decay,n.spot[v]=Y;let J=I.shadow;if(I.map&&(n.spotLightMap[b]=I.map,b++,J.updateMatrices(I),I.castShadow&&F++),n.spotLightMatrix[v]=J.matrix,I.castShadow){let G=e.get(I);G.shadowIntensity=J.intensity,G.shadowBias=J.bias,G.shadowNormalBias=J.normalBias,G.shadowRadius=J.radius,G.shadowMapSize=J.mapSize,n.spotShadow[v]=G,n.spotShadowMap[v]=ot,_++}v++}else if(I.isRectAreaLight){let Y=t.get(I);Y.color.copy(V).multiplyScalar(H),Y.halfWidth.set(I.width*.5,0,0),Y.halfHeight.set(0,I.height*.5,0),n.rectArea[R]=Y,R++}else if(I.isPointLight){let Y=t.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),Y.distance=I.distance,Y.decay=I.decay,I.castShadow){let J=I.shadow,G=e.get(I);G.shadowIntensity=J.intensity,G.shadowBias=J.bias,G.shadowNormalBias=J.normalBias,G.shadowRadius=J.radius,G.shadowMapSize=J.mapSize,G.shadowCameraNear=J.camera.near,G.shadowCameraFar=J.camera.far,n.pointShadow[g]=G,n.pointShadowMap[g]=ot,n.pointShadowMatrix[g]=I.shadow.matrix,M++}n.point[g]=Y,g++}else if(I.isHemisphereLight){let Y=t.get(I);Y.skyColor.copy(I.color).multiplyScalar(H),Y.groundColor.copy(I.groundColor).multiplyScalar(H),n.hemi[S]=Y,S++}}R>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Lt.LTC_FLOAT_1,n.rectAreaLTC2=Lt.LTC_FLOAT_2):(n.rectAreaLTC1=Lt.LTC_HALF_1,n.rectAreaLTC2=Lt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=d,n.ambient[2]=u;let P=n.hash;(P.sunLength!==f||P.directionalLength!==m||P.pointLength!==g||P.spotLength!==v||P.rectAreaLength!==R||P.hemiLength!==S||P.numSunShadows!==p||P.numDirectionalShadows!==C||P.numPointShadows!==M||P.numSpotShadows!==_||P.numSpotMaps!==b||P.numLightProbes!==A)&&(n.sun.length=f,n.directional.length=m,n.spot.length=v,n.rectArea.length=R,n.point.length=g,n.hemi.length=S,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=M,n.pointShadowMap.length=M,n.pointShadowMatrix.length=M,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+b-F,n.spotLightMap.length=b,n.numSpotLightShadowsWithMaps=F,n.numLightProbes=A,P.sunLength=f,P.directionalLength=m,P.pointLength=g,P.spotLength=v,P.rectAreaLength=R,P.hemiLength=S,P.numSunShadows=p,P.numDirectionalShadows=C,P.numPointShadows=M,P.numSpotShadows=_,P.numSpotMaps=b,P.numLightProbes=A,n.version=z1++)}function c(l,h){let d=0,u=0,f=0,p=0,y=0,m=0,g=h.matrixWorldInverse;for(let v=0,R=l.length;v<R;v++){let S=l[v];if(S.isSunLight){let C=n.sun[d];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(g),d++}else if(S.isDirectionalLight){let C=n.directional[u];C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),u++}else if(S.isSpotLight){let C=n.spot[p];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(g),C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),p++}else if(S.isRectAreaLight){let C=n.rectArea[y];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(g),o.identity(),r.copy(S.matrixWorld),r.premultiply(g),o.extractRotation(r),C.halfWidth.set(S.width*.5,0,0),C.halfHeight.set(0,S.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),y++}else if(S.isPointLight){let C=n.point[f];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(g),f++}else if(S.isHemisphereLight){let C=n.hemi[m];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(g),m++}}}return{setup:a,setupView:c,state:n}}function v0(i){let t=new G1(i),e=[],n=[],s=[];function r(d){h.camera=d,e.length=0,n.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):e.push(d)}function a(d){n.push(d)}function c(){t.setup(e),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function l(d){t.setupView(e,d)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function H1(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new v0(i),t.set(s,[a])):r>=o.length?(a=new v0(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var W1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,X1=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,q1=[new $(1,0,0),new $(-1,0,0),new $(0,1,0),new $(0,-1,0),new $(0,0,1),new $(0,0,-1)],Y1=[new $(0,-1,0),new $(0,-1,0),new $(0,0,1),new $(0,0,-1),new $(0,-1,0),new $(0,-1,0)],y0=new Ae,Ga=new $,Gd=new $;function $1(i,t,e){let n=new Ys,s=new ne,r=new ne,o=new Ze,a=new mc,c=new gc,l={},h=e.maxTextureSize,d={[tr]:ni,[ni]:tr,[ri]:ri},u=new ts({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ne},radius:{value:4}},vertexShader:W1,fragmentShader:X1}),f=u.clone();f.defines.HORIZONTAL_PASS=1;let p=new Fn;p.setAttribute("position",new Wn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new qn(p,u),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Na;let g=this.type;this.render=function(M,_,b){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||M.length===0)return;this.type===fg&&(Jt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Na);let F=i.getRenderTarget(),A=i.getActiveCubeFace(),P=i.getActiveMipmapLevel(),D=i.state;D.setBlending(br),D.buffers.depth.getReversed()===!0?D.buffers.color.setClear(0,0,0,0):D.buffers.color.setClear(1,1,1,1),D.buffers.depth.setTest(!0),D.setScissorTest(!1);let O=g!==this.type;O&&_.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(V=>V.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,V=M.length;I<V;I++){let H=M[I],z=H.shadow;if(z===void 0){Jt("WebGLShadowMap:",H,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let ot=z.getFrameExtents();s.multiply(ot),r.copy(z.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ot.x),s.x=r.x*ot.x,z.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ot.y),s.y=r.y*ot.y,z.mapSize.y=r.y));let Y=i.state.buffers.depth.getReversed();if(z.camera._reversedDepth=Y,z.map===null||O===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===Ro){if(H.isPointLight){Jt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new xi(s.x,s.y,{format:er,type:Vi,minFilter:Un,magFilter:Un,generateMipmaps:!1}),z.map.texture.name=H.name+".shadowMap",z.map.depthTexture=new Es(s.x,s.y,Ri),z.map.depthTexture.name=H.name+".shadowMapDepth",z.map.depthTexture.format=bs,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Ln,z.map.depthTexture.magFilter=Ln}else H.isPointLight?(z.map=new Wa(s.x),z.map.depthTexture=new Ma(s.x,zi)):(z.map=new xi(s.x,s.y),z.map.depthTexture=new Es(s.x,s.y,zi)),z.map.depthTexture.name=H.name+".shadowMap",z.map.depthTexture.format=bs,this.type===Na?(z.map.depthTexture.compareFunction=Y?Pd:Cd,z.map.depthTexture.minFilter=Un,z.map.depthTexture.magFilter=Un):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Ln,z.map.depthTexture.magFilter=Ln);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==s.x||z.map.height!==s.y)&&z.map.setSize(s.x,s.y);let J=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();H.isPointLight!==!0&&z.updateMatrices(H,b);let G=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:b.layers;for(let nt=0;nt<J;nt++){let lt=z.getCamera(nt);if(H.isPointLight){let j=z.camera,ut=z.matrix,dt=H.distance||j.far;dt!==j.far&&(j.far=dt,j.updateProjectionMatrix()),Ga.setFromMatrixPosition(H.matrixWorld),j.position.copy(Ga),Gd.copy(j.position),Gd.add(q1[nt]),j.up.copy(Y1[nt]),j.lookAt(Gd),j.updateMatrixWorld(),ut.makeTranslation(-Ga.x,-Ga.y,-Ga.z),y0.multiplyMatrices(j.projectionMatrix,j.matrixWorldInverse),z._frustum.setFromProjectionMatrix(y0,j.coordinateSystem,j.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)i.setRenderTarget(z.map,nt),i.clear();else{nt===0&&(i.setRenderTarget(z.map),i.clear());let j=z.getViewport(nt);o.set(r.x*j.x,r.y*j.y,r.x*j.z,r.y*j.w),D.viewport(o)}n=z.getFrustum(nt),S(_,b,lt,H,G,this.type)}z.isPointLightShadow!==!0&&this.type===Ro&&v(z,b),z.needsUpdate=!1}g=this.type,m.needsUpdate=!1,i.setRenderTarget(F,A,P)};function v(M,_){let b=t.update(y);u.defines.VSM_SAMPLES!==M.blurSamples&&(u.defines.VSM_SAMPLES=M.blurSamples,f.defines.VSM_SAMPLES=M.blurSamples,u.needsUpdate=!0,f.needsUpdate=!0),M.mapPass===null?M.mapPass=new xi(s.x,s.y,{format:er,type:Vi}):(M.mapPass.width!==M.map.width||M.mapPass.height!==M.map.height)&&M.mapPass.setSize(M.map.width,M.map.height),u.uniforms.shadow_pass.value=M.map.depthTexture,u.uniforms.resolution.value.set(M.map.width,M.map.height),u.uniforms.radius.value=M.radius,i.setRenderTarget(M.mapPass),i.clear(),i.renderBufferDirect(_,null,b,u,y,null),f.uniforms.shadow_pass.value=M.mapPass.texture,f.uniforms.resolution.value.set(M.map.width,M.map.height),f.uniforms.radius.value=M.radius,i.setRenderTarget(M.map),i.clear(),i.renderBufferDirect(_,null,b,f,y,null)}function R(M,_,b,F){let A=null,P=b.isPointLight===!0?M.customDistanceMaterial:M.customDepthMaterial;if(P!==void 0)A=P;else if(A=b.isPointLight===!0?c:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let D=A.uuid,O=_.uuid,I=l[D];I===void 0&&(I={},l[D]=I);let V=I[O];V===void 0&&(V=A.clone(),I[O]=V,_.addEventListener("dispose",C)),A=V}if(A.visible=_.visible,A.wireframe=_.wireframe,F===Ro?A.side=_.shadowSide!==null?_.shadowSide:_.side:A.side=_.shadowSide!==null?_.shadowSide:d[_.side],A.alphaMap=_.alphaMap,A.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,A.map=_.map,A.clipShadows=_.clipShadows,A.clippingPlanes=_.clippingPlanes,A.clipIntersection=_.clipIntersection,A.displacementMap=_.displacementMap,A.displacementScale=_.displacementScale,A.displacementBias=_.displacementBias,A.wireframeLinewidth=_.wireframeLinewidth,A.linewidth=_.linewidth,b.isPointLight===!0&&A.isMeshDistanceMaterial===!0){let D=i.properties.get(A);D.light=b}return A}function S(M,_,b,F,A,P){if(M.visible===!1)return;if(M.layers.test(A)&&(M.isMesh||M.isLine||M.isPoints)&&(M.castShadow||M.receiveShadow&&P===Ro)&&(!M.frustumCulled||M.intersectsFrustum(n))){M.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,M.matrixWorld);let I=t.update(M),V=M.material;if(Array.isArray(V)){let H=I.groups;for(let z=0,ot=H.length;z<ot;z++){let Y=H[z],J=V[Y.materialIndex];if(J&&J.visible){let G=R(M,J,F,P);M.onBeforeShadow(i,M,_,b,I,G,Y),i.renderBufferDirect(b,null,I,G,M,Y),M.onAfterShadow(i,M,_,b,I,G,Y)}}}else if(V.visible){let H=R(M,V,F,P);M.onBeforeShadow(i,M,_,b,I,H,null),i.renderBufferDirect(b,null,I,H,M,null),M.onAfterShadow(i,M,_,b,I,H,null)}}let O=M.children;for(let I=0,V=O.length;I<V;I++)S(O[I],_,b,F,A,P)}function C(M){M.target.removeEventListener("dispose",C);for(let b in l){let F=l[b],A=M.target.uuid;A in F&&(F[A].dispose(),delete F[A])}}}function Z1(i,t){function e(){let B=!1,at=new Ze,st=null,Tt=new Ze(0,0,0,0);return{setMask:function(vt){st!==vt&&!B&&(i.colorMask(vt,vt,vt,vt),st=vt)},setLocked:function(vt){B=vt},setClear:function(vt,Mt,Xt,te,ft){ft===!0&&(vt*=te,Mt*=te,Xt*=te),at.set(vt,Mt,Xt,te),Tt.equals(at)===!1&&(i.clearColor(vt,Mt,Xt,te),Tt.copy(at))},reset:function(){B=!1,st=null,Tt.set(-1,0,0,0)}}}function n(){let B=!1,at=!1,st=null,Tt=null,vt=null;return{setReversed:function(Mt){if(at!==Mt){let Xt=t.get("EXT_clip_control");Mt?Xt.clipControlEXT(Xt.LOWER_LEFT_EXT,Xt.ZERO_TO_ONE_EXT):Xt.clipControlEXT(Xt.LOWER_LEFT_EXT,Xt.NEGATIVE_ONE_TO_ONE_EXT),at=Mt;let te=vt;vt=null,this.setClear(te)}},getReversed:function(){return at},setTest:function(Mt){Mt?pt(i.DEPTH_TEST):Dt(i.DEPTH_TEST)},setMask:function(Mt){st!==Mt&&!B&&(i.depthMask(Mt),st=Mt)},setFunc:function(Mt){if(at&&(Mt=Yg[Mt]),Tt!==Mt){switch(Mt){case Kl:i.depthFunc(i.NEVER);break;case jl:i.depthFunc(i.ALWAYS);break;case Ql:i.depthFunc(i.LESS);break;case go:i.depthFunc(i.LEQUAL);break;case tc:i.depthFunc(i.EQUAL);break;case ec:i.depthFunc(i.GEQUAL);break;case nc:i.depthFunc(i.GREATER);break;case ic:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Tt=Mt}},setLocked:function(Mt){B=Mt},setClear:function(Mt){vt!==Mt&&(vt=Mt,at&&(Mt=1-Mt),i.clearDepth(Mt))},reset:function(){B=!1,st=null,Tt=null,vt=null,at=!1}}}function s(){let B=!1,at=null,st=null,Tt=null,vt=null,Mt=null,Xt=null,te=null,ft=null;return{setTest:function(kt){B||(kt?pt(i.STENCIL_TEST):Dt(i.STENCIL_TEST))},setMask:function(kt){at!==kt&&!B&&(i.stencilMask(kt),at=kt)},setFunc:function(kt,ee,Rt){(st!==kt||Tt!==ee||vt!==Rt)&&(i.stencilFunc(kt,ee,Rt),st=kt,Tt=ee,vt=Rt)},setOp:function(kt,ee,Rt){(Mt!==kt||Xt!==ee||te!==Rt)&&(i.stencilOp(kt,ee,Rt),Mt=kt,Xt=ee,te=Rt)},setLocked:function(kt){B=kt},setClear:function(kt){ft!==kt&&(i.clearStencil(kt),ft=kt)},reset:function(){B=!1,at=null,st=null,Tt=null,vt=null,Mt=null,Xt=null,te=null,ft=null}}}let r=new e,o=new n,a=new s,c={},l=new WeakMap,h={},d={},u={},f=new WeakMap,p=[],y=null,m=!1,g=null,v=null,R=null,S=null,C=null,M=null,_=null,b=new pe(0,0,0),F=0,A=!1,P=null,D=null,O=null,I=null,V=null,H=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,ot=0,Y=i.getParameter(i.VERSION);Y.indexOf("WebGL")!==-1?(ot=parseFloat(/^WebGL (\d)/.exec(Y)[1]),z=ot>=1):Y.indexOf("OpenGL ES")!==-1&&(ot=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),z=ot>=2);let J=null,G={},nt=i.getParameter(i.SCISSOR_BOX),lt=i.getParameter(i.VIEWPORT),j=new Ze().fromArray(nt),ut=new Ze().fromArray(lt);function dt(B,at,st,Tt){let vt=new Uint8Array(4),Mt=i.createTexture();i.bindTexture(B,Mt),i.texParameteri(B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Xt=0;Xt<st;Xt++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(at,0,i.RGBA,1,1,Tt,0,i.RGBA,i.UNSIGNED_BYTE,vt):i.texImage2D(at+Xt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,vt);return Mt}let gt={};gt[i.TEXTURE_2D]=dt(i.TEXTURE_2D,i.TEXTURE_2D,1),gt[i.TEXTURE_CUBE_MAP]=dt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),gt[i.TEXTURE_2D_ARRAY]=dt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),gt[i.TEXTURE_3D]=dt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),pt(i.DEPTH_TEST),o.setFunc(go),Ke(!1),Ue(cd),pt(i.CULL_FACE),Ve(br);function pt(B){h[B]!==!0&&(i.enable(B),h[B]=!0)}function Dt(B){h[B]!==!1&&(i.disable(B),h[B]=!1)}function qt(B,at){return u[B]!==at?(i.bindFramebuffer(B,at),u[B]=at,B===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=at),B===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=at),!0):!1}function Ft(B,at){let st=p,Tt=!1;if(B){st=f.get(at),st===void 0&&(st=[],f.set(at,st));let vt=B.textures;if(st.length!==vt.length||st[0]!==i.COLOR_ATTACHMENT0){for(let Mt=0,Xt=vt.length;Mt<Xt;Mt++)st[Mt]=i.COLOR_ATTACHMENT0+Mt;st.length=vt.length,Tt=!0}}else st[0]!==i.BACK&&(st[0]=i.BACK,Tt=!0);Tt&&i.drawBuffers(st)}function oe(B){return y!==B?(i.useProgram(B),y=B,!0):!1}let he={[Mr]:i.FUNC_ADD,[mg]:i.FUNC_SUBTRACT,[gg]:i.FUNC_REVERSE_SUBTRACT};he[_g]=i.MIN,he[xg]=i.MAX;let Qt={[vg]:i.ZERO,[yg]:i.ONE,[Sg]:i.SRC_COLOR,[fd]:i.SRC_ALPHA,[Ag]:i.SRC_ALPHA_SATURATE,[Tg]:i.DST_COLOR,[Mg]:i.DST_ALPHA,[bg]:i.ONE_MINUS_SRC_COLOR,[pd]:i.ONE_MINUS_SRC_ALPHA,[Eg]:i.ONE_MINUS_DST_COLOR,[wg]:i.ONE_MINUS_DST_ALPHA,[Rg]:i.CONSTANT_COLOR,[Cg]:i.ONE_MINUS_CONSTANT_COLOR,[Pg]:i.CONSTANT_ALPHA,[Ig]:i.ONE_MINUS_CONSTANT_ALPHA};function Ve(B,at,st,Tt,vt,Mt,Xt,te,ft,kt){if(B===br){m===!0&&(Dt(i.BLEND),m=!1);return}if(m===!1&&(pt(i.BLEND),m=!0),B!==pg){if(B!==g||kt!==A){if((v!==Mr||C!==Mr)&&(i.blendEquation(i.FUNC_ADD),v=Mr,C=Mr),kt)switch(B){case Co:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case hd:i.blendFunc(i.ONE,i.ONE);break;case ud:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case dd:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:se("WebGLState: Invalid blending: ",B);break}else switch(B){case Co:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case hd:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case ud:se("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case dd:se("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:se("WebGLState: Invalid blending: ",B);break}R=null,S=null,M=null,_=null,b.set(0,0,0),F=0,g=B,A=kt}return}vt=vt||at,Mt=Mt||st,Xt=Xt||Tt,(at!==v||vt!==C)&&(i.blendEquationSeparate(he[at],he[vt]),v=at,C=vt),(st!==R||Tt!==S||Mt!==M||Xt!==_)&&(i.blendFuncSeparate(Qt[st],Qt[Tt],Qt[Mt],Qt[Xt]),R=st,S=Tt,M=Mt,_=Xt),(te.equals(b)===!1||ft!==F)&&(i.blendColor(te.r,te.g,te.b,ft),b.copy(te),F=ft),g=B,A=!1}function Ce(B,at){B.side===ri?Dt(i.CULL_FACE):pt(i.CULL_FACE);let st=B.side===ni;at&&(st=!st),Ke(st),B.blending===Co&&B.transparent===!1?Ve(br):Ve(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let Tt=B.stencilWrite;a.setTest(Tt),Tt&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),be(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?pt(i.SAMPLE_ALPHA_TO_COVERAGE):Dt(i.SAMPLE_ALPHA_TO_COVERAGE)}function Ke(B){P!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),P=B)}function Ue(B){B!==ug?(pt(i.CULL_FACE),B!==D&&(B===cd?i.cullFace(i.BACK):B===dg?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Dt(i.CULL_FACE),D=B}function bn(B){B!==O&&(z&&i.lineWidth(B),O=B)}function be(B,at,st){B?(pt(i.POLYGON_OFFSET_FILL),(I!==at||V!==st)&&(I=at,V=st,o.getReversed()&&(at=-at,st=-st),i.polygonOffset(at,st))):Dt(i.POLYGON_OFFSET_FILL)}function pn(B){B?pt(i.SCISSOR_TEST):Dt(i.SCISSOR_TEST)}function je(B){B===void 0&&(B=i.TEXTURE0+H-1),J!==B&&(i.activeTexture(B),J=B)}function an(B,at,st){st===void 0&&(J===null?st=i.TEXTURE0+H-1:st=J);let Tt=G[st];Tt===void 0&&(Tt={type:void 0,texture:void 0},G[st]=Tt),(Tt.type!==B||Tt.texture!==at)&&(J!==st&&(i.activeTexture(st),J=st),i.bindTexture(B,at||gt[B]),Tt.type=B,Tt.texture=at)}function k(){let B=G[J];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Ct(){try{i.compressedTexImage2D(...arguments)}catch(B){se("WebGLState:",B)}}function Kt(){try{i.compressedTexImage3D(...arguments)}catch(B){se("WebGLState:",B)}}function ce(){try{i.texSubImage2D(...arguments)}catch(B){se("WebGLState:",B)}}function wt(){try{i.texSubImage3D(...arguments)}catch(B){se("WebGLState:",B)}}function Oe(){try{i.compressedTexSubImage2D(...arguments)}catch(B){se("WebGLState:",B)}}function Wt(){try{i.compressedTexSubImage3D(...arguments)}catch(B){se("WebGLState:",B)}}function Zt(){try{i.texStorage2D(...arguments)}catch(B){se("WebGLState:",B)}}function L(){try{i.texStorage3D(...arguments)}catch(B){se("WebGLState:",B)}}function w(){try{i.texImage2D(...arguments)}catch(B){se("WebGLState:",B)}}function Z(){try{i.texImage3D(...arguments)}catch(B){se("WebGLState:",B)}}function mt(B){return d[B]!==void 0?d[B]:i.getParameter(B)}function ct(B,at){d[B]!==at&&(i.pixelStorei(B,at),d[B]=at)}function yt(B){j.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),j.copy(B))}function St(B){ut.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),ut.copy(B))}function it(B,at){let st=l.get(at);st===void 0&&(st=new WeakMap,l.set(at,st));let Tt=st.get(B);Tt===void 0&&(Tt=i.getUniformBlockIndex(at,B.name),i.uniformBlockBinding(at,Tt,Tt),st.set(B,Tt))}function rt(B,at,st){let vt=l.get(at).get(B);c[vt]!==st&&(i.bindBufferBase(i.UNIFORM_BUFFER,vt,st),c[vt]=st)}function xt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},d={},J=null,G={},u={},c={},f=new WeakMap,p=[],y=null,m=!1,g=null,v=null,R=null,S=null,C=null,M=null,_=null,b=new pe(0,0,0),F=0,A=!1,P=null,D=null,O=null,I=null,V=null,j.set(0,0,i.canvas.width,i.canvas.height),ut.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:pt,disable:Dt,bindFramebuffer:qt,drawBuffers:Ft,useProgram:oe,setBlending:Ve,setMaterial:Ce,setFlipSided:Ke,setCullFace:Ue,setLineWidth:bn,setPolygonOffset:be,setScissorTest:pn,activeTexture:je,bindTexture:an,unbindTexture:k,compressedTexImage2D:Ct,compressedTexImage3D:Kt,texImage2D:w,texImage3D:Z,pixelStorei:ct,getParameter:mt,updateUBOMapping:it,uniformBlockBinding:rt,texStorage2D:Zt,texStorage3D:L,texSubImage2D:ce,texSubImage3D:wt,compressedTexSubImage2D:Oe,compressedTexSubImage3D:Wt,scissor:yt,viewport:St,reset:xt}}function J1(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new ne,h=new WeakMap,d=new Set,u,f=new WeakMap,p=new Set,y=new FinalizationRegistry(L=>p.delete(L)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(L,w){return m?new OffscreenCanvas(L,w):pa("canvas")}function v(L,w,Z){let mt=1,ct=Zt(L);if((ct.width>Z||ct.height>Z)&&(mt=Z/Math.max(ct.width,ct.height)),mt<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let yt=Math.floor(mt*ct.width),St=Math.floor(mt*ct.height);u===void 0&&(u=g(yt,St));let it=w?g(yt,St):u;return it.width=yt,it.height=St,it.getContext("2d").drawImage(L,0,0,yt,St),Jt("WebGLRenderer: Texture has been resized from ("+ct.width+"x"+ct.height+") to ("+yt+"x"+St+")."),it}else return"data"in L&&Jt("WebGLRenderer: Image in DataTexture is too big ("+ct.width+"x"+ct.height+")."),L;return L}function R(L){return L.generateMipmaps}function S(L){i.generateMipmap(L)}function C(L){return L.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?i.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function M(L,w,Z,mt,ct,yt=!1){if(L!==null){if(i[L]!==void 0)return i[L];Jt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let St;mt&&(St=t.get("EXT_texture_norm16"),St||Jt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let it=w;if(w===i.RED&&(Z===i.FLOAT&&(it=i.R32F),Z===i.HALF_FLOAT&&(it=i.R16F),Z===i.UNSIGNED_BYTE&&(it=i.R8),Z===i.UNSIGNED_SHORT&&St&&(it=St.R16_EXT),Z===i.SHORT&&St&&(it=St.R16_SNORM_EXT)),w===i.RED_INTEGER&&(Z===i.UNSIGNED_BYTE&&(it=i.R8UI),Z===i.UNSIGNED_SHORT&&(it=i.R16UI),Z===i.UNSIGNED_INT&&(it=i.R32UI),Z===i.BYTE&&(it=i.R8I),Z===i.SHORT&&(it=i.R16I),Z===i.INT&&(it=i.R32I)),w===i.RG&&(Z===i.FLOAT&&(it=i.RG32F),Z===i.HALF_FLOAT&&(it=i.RG16F),Z===i.UNSIGNED_BYTE&&(it=i.RG8),Z===i.UNSIGNED_SHORT&&St&&(it=St.RG16_EXT),Z===i.SHORT&&St&&(it=St.RG16_SNORM_EXT)),w===i.RG_INTEGER&&(Z===i.UNSIGNED_BYTE&&(it=i.RG8UI),Z===i.UNSIGNED_SHORT&&(it=i.RG16UI),Z===i.UNSIGNED_INT&&(it=i.RG32UI),Z===i.BYTE&&(it=i.RG8I),Z===i.SHORT&&(it=i.RG16I),Z===i.INT&&(it=i.RG32I)),w===i.RGB_INTEGER&&(Z===i.UNSIGNED_BYTE&&(it=i.RGB8UI),Z===i.UNSIGNED_SHORT&&(it=i.RGB16UI),Z===i.UNSIGNED_INT&&(it=i.RGB32UI),Z===i.BYTE&&(it=i.RGB8I),Z===i.SHORT&&(it=i.RGB16I),Z===i.INT&&(it=i.RGB32I)),w===i.RGBA_INTEGER&&(Z===i.UNSIGNED_BYTE&&(it=i.RGBA8UI),Z===i.UNSIGNED_SHORT&&(it=i.RGBA16UI),Z===i.UNSIGNED_INT&&(it=i.RGBA32UI),Z===i.BYTE&&(it=i.RGBA8I),Z===i.SHORT&&(it=i.RGBA16I),Z===i.INT&&(it=i.RGBA32I)),w===i.RGB&&(Z===i.UNSIGNED_SHORT&&St&&(it=St.RGB16_EXT),Z===i.SHORT&&St&&(it=St.RGB16_SNORM_EXT),Z===i.UNSIGNED_INT_5_9_9_9_REV&&(it=i.RGB9_E5),Z===i.UNSIGNED_INT_10F_11F_11F_REV&&(it=i.R11F_G11F_B10F)),w===i.RGBA){let rt=yt?fa:Se.getTransfer(ct);Z===i.FLOAT&&(it=i.RGBA32F),Z===i.HALF_FLOAT&&(it=i.RGBA16F),Z===i.UNSIGNED_BYTE&&(it=rt===Ie?i.SRGB8_ALPHA8:i.RGBA8),Z===i.UNSIGNED_SHORT&&St&&(it=St.RGBA16_EXT),Z===i.SHORT&&St&&(it=St.RGBA16_SNORM_EXT),Z===i.UNSIGNED_SHORT_4_4_4_4&&(it=i.RGBA4),Z===i.UNSIGNED_SHORT_5_5_5_1&&(it=i.RGB5_A1)}return(it===i.R16F||it===i.R32F||it===i.RG16F||it===i.RG32F||it===i.RGBA16F||it===i.RGBA32F)&&t.get("EXT_color_buffer_float"),it}function _(L,w){let Z;return L?w===null||w===zi||w===Tr?Z=i.DEPTH24_STENCIL8:w===Ri?Z=i.DEPTH32F_STENCIL8:w===Io&&(Z=i.DEPTH24_STENCIL8,Jt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===zi||w===Tr?Z=i.DEPTH_COMPONENT24:w===Ri?Z=i.DEPTH_COMPONENT32F:w===Io&&(Z=i.DEPTH_COMPONENT16),Z}function b(L,w){return R(L)===!0||L.isFramebufferTexture&&L.minFilter!==Ln&&L.minFilter!==Un?Math.log2(Math.max(w.width,w.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?w.mipmaps.length:1}function F(L){let w=new WeakRef(L);n.get(L).__ref=w,p.add(w),y.register(L,w,w)}function A(L){let w=n.get(L).__ref;w!==void 0&&(p.delete(w),y.unregister(w))}function P(L){O(L.target)}function D(L){I(L.target)}function O(L){L.removeEventListener("dispose",P),A(L),H(L),L.isVideoTexture&&h.delete(L),L.isHTMLTexture&&d.delete(L)}function I(L){L.removeEventListener("dispose",D),A(L),ot(L)}function V(){for(let L of p){let w=L.deref();w!==void 0&&(w.isRenderTarget===!0?I(w):O(w))}p.clear(),d.clear()}function H(L){let w=n.get(L);if(w.__webglInit===void 0)return;let Z=L.source,mt=f.get(Z);if(mt){let ct=mt[w.__cacheKey];ct.usedTimes--,ct.usedTimes===0&&z(L),Object.keys(mt).length===0&&f.delete(Z)}n.remove(L)}function z(L){let w=n.get(L);i.deleteTexture(w.__webglTexture);let Z=L.source,mt=f.get(Z);delete mt[w.__cacheKey],o.memory.textures--}function ot(L){let w=n.get(L);w.__depthDisposeCallback&&w.__depthDisposeCallback();let Z=L.depthTexture;if(Z&&Z.renderTarget===L&&O(Z),L.isWebGLCubeRenderTarget)for(let ct=0;ct<6;ct++){if(Array.isArray(w.__webglFramebuffer[ct]))for(let yt=0;yt<w.__webglFramebuffer[ct].length;yt++)i.deleteFramebuffer(w.__webglFramebuffer[ct][yt]);else i.deleteFramebuffer(w.__webglFramebuffer[ct]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[ct])}else{if(Array.isArray(w.__webglFramebuffer))for(let ct=0;ct<w.__webglFramebuffer.length;ct++)i.deleteFramebuffer(w.__webglFramebuffer[ct]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let ct=0;ct<w.__webglColorRenderbuffer.length;ct++)w.__webglColorRenderbuffer[ct]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[ct]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let mt=L.textures;for(let ct=0,yt=mt.length;ct<yt;ct++){let St=n.get(mt[ct]);St.__webglTexture&&(i.deleteTexture(St.__webglTexture),o.memory.textures--),n.remove(mt[ct])}n.remove(L)}let Y=0;function J(){Y=0}function G(){return Y}function nt(L){Y=L}function lt(){let L=Y;return L>=s.maxTextures&&Jt("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,L}function j(L){let w=[];return w.push(L.wrapS),w.push(L.wrapT),w.push(L.wrapR||0),w.push(L.magFilter),w.push(L.minFilter),w.push(L.anisotropy),w.push(L.internalFormat),w.push(L.format),w.push(L.type),w.push(L.generateMipmaps),w.push(L.mipmapsAutoUpdate),w.push(L.premultiplyAlpha),w.push(L.flipY),w.push(L.unpackAlignment),w.push(L.colorSpace),w.join()}function ut(L,w){let Z=n.get(L);if(L.isVideoTexture&&Oe(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&Z.__version!==L.version){let mt=L.image;if(mt===null)Jt("WebGLRenderer: Texture marked for update but no image data found.");else if(mt.complete===!1)Jt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ce(Z,L,w);return}}else L.isExternalTexture&&(Z.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,Z.__webglTexture,i.TEXTURE0+w)}function dt(L,w){let Z=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&Z.__version!==L.version){Ce(Z,L,w);return}else L.isExternalTexture&&(Z.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,Z.__webglTexture,i.TEXTURE0+w)}function gt(L,w){let Z=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&Z.__version!==L.version){Ce(Z,L,w);return}e.bindTexture(i.TEXTURE_3D,Z.__webglTexture,i.TEXTURE0+w)}function pt(L,w){let Z=n.get(L);if(L.version>0&&Z.__version!==L.version){Ke(Z,L,w);return}e.bindTexture(i.TEXTURE_CUBE_MAP,Z.__webglTexture,i.TEXTURE0+w)}let Dt={[sc]:i.REPEAT,[ji]:i.CLAMP_TO_EDGE,[rc]:i.MIRRORED_REPEAT},qt={[Ln]:i.NEAREST,[Ng]:i.NEAREST_MIPMAP_NEAREST,[Ua]:i.NEAREST_MIPMAP_LINEAR,[Un]:i.LINEAR,[Lc]:i.LINEAR_MIPMAP_NEAREST,[As]:i.LINEAR_MIPMAP_LINEAR},Ft={[Bg]:i.NEVER,[Id]:i.ALWAYS,[kg]:i.LESS,[Cd]:i.LEQUAL,[zg]:i.EQUAL,[Pd]:i.GEQUAL,[Vg]:i.GREATER,[Gg]:i.NOTEQUAL};function oe(L,w){if(w.type===Ri&&t.has("OES_texture_float_linear")===!1&&(w.magFilter===Un||w.magFilter===Lc||w.magFilter===Ua||w.magFilter===As||w.minFilter===Un||w.minFilter===Lc||w.minFilter===Ua||w.minFilter===As)&&Jt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(L,i.TEXTURE_WRAP_S,Dt[w.wrapS]),i.texParameteri(L,i.TEXTURE_WRAP_T,Dt[w.wrapT]),(L===i.TEXTURE_3D||L===i.TEXTURE_2D_ARRAY)&&i.texParameteri(L,i.TEXTURE_WRAP_R,Dt[w.wrapR]),i.texParameteri(L,i.TEXTURE_MAG_FILTER,qt[w.magFilter]),i.texParameteri(L,i.TEXTURE_MIN_FILTER,qt[w.minFilter]),w.compareFunction&&(i.texParameteri(L,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(L,i.TEXTURE_COMPARE_FUNC,Ft[w.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===Ln||w.minFilter!==Ua&&w.minFilter!==As||w.type===Ri&&t.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){let Z=t.get("EXT_texture_filter_anisotropic");i.texParameterf(L,Z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function he(L,w){let Z=!1;L.__webglInit===void 0&&(L.__webglInit=!0,w.addEventListener("dispose",P),F(w));let mt=w.source,ct=f.get(mt);ct===void 0&&(ct={},f.set(mt,ct));let yt=j(w);if(yt!==L.__cacheKey){ct[yt]===void 0&&(ct[yt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,Z=!0),ct[yt].usedTimes++;let St=ct[L.__cacheKey];St!==void 0&&(ct[L.__cacheKey].usedTimes--,St.usedTimes===0&&z(w)),L.__cacheKey=yt,L.__webglTexture=ct[yt].texture}return Z}function Qt(L,w,Z){return Math.floor(Math.floor(L/Z)/w)}function Ve(L,w,Z,mt){let yt=L.updateRanges;if(yt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,w.width,w.height,Z,mt,w.data);else{yt.sort((B,at)=>B.start-at.start);let St=0;for(let B=1;B<yt.length;B++){let at=yt[St],st=yt[B],Tt=at.start+at.count,vt=Qt(st.start,w.width,4),Mt=Qt(at.start,w.width,4);st.start<=Tt+1&&vt===Mt&&Qt(st.start+st.count-1,w.width,4)===vt?at.count=Math.max(at.count,st.start+st.count-at.start):(++St,yt[St]=st)}yt.length=St+1;let it=e.getParameter(i.UNPACK_ROW_LENGTH),rt=e.getParameter(i.UNPACK_SKIP_PIXELS),xt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,w.width);for(let B=0,at=yt.length;B<at;B++){let st=yt[B],Tt=Math.floor(st.start/4),vt=Math.ceil(st.count/4),Mt=Tt%w.width,Xt=Math.floor(Tt/w.width),te=vt,ft=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,Mt),e.pixelStorei(i.UNPACK_SKIP_ROWS,Xt),e.texSubImage2D(i.TEXTURE_2D,0,Mt,Xt,te,ft,Z,mt,w.data)}L.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,it),e.pixelStorei(i.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(i.UNPACK_SKIP_ROWS,xt)}}function Ce(L,w,Z){let mt=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(mt=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(mt=i.TEXTURE_3D);let ct=he(L,w),yt=w.source;e.bindTexture(mt,L.__webglTexture,i.TEXTURE0+Z);let St=n.get(yt);if(yt.version!==St.__version||ct===!0){if(e.activeTexture(i.TEXTURE0+Z),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let ft=Se.getPrimaries(Se.workingColorSpace),kt=w.colorSpace===Cs?null:Se.getPrimaries(w.colorSpace),ee=w.colorSpace===Cs||ft===kt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ee)}e.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment);let rt=v(w.image,!1,s.maxTextureSize);rt=Wt(w,rt);let xt=r.convert(w.format,w.colorSpace),B=r.convert(w.type),at=M(w.internalFormat,xt,B,w.normalized,w.colorSpace,w.isVideoTexture);oe(mt,w);let st,Tt=w.mipmaps,vt=w.isVideoTexture!==!0,Mt=St.__version===void 0||ct===!0,Xt=yt.dataReady,te=b(w,rt);if(w.isDepthTexture)at=_(w.format===Rs,w.type),Mt&&(vt?e.texStorage2D(i.TEXTURE_2D,1,at,rt.width,rt.height):e.texImage2D(i.TEXTURE_2D,0,at,rt.width,rt.height,0,xt,B,null));else if(w.isDataTexture)if(Tt.length>0){vt&&Mt&&e.texStorage2D(i.TEXTURE_2D,te,at,Tt[0].width,Tt[0].height);for(let ft=0,kt=Tt.length;ft<kt;ft++)st=Tt[ft],vt?Xt&&e.texSubImage2D(i.TEXTURE_2D,ft,0,0,st.width,st.height,xt,B,st.data):e.texImage2D(i.TEXTURE_2D,ft,at,st.width,st.height,0,xt,B,st.data);w.generateMipmaps=!1}else vt?(Mt&&e.texStorage2D(i.TEXTURE_2D,te,at,rt.width,rt.height),Xt&&Ve(w,rt,xt,B)):e.texImage2D(i.TEXTURE_2D,0,at,rt.width,rt.height,0,xt,B,rt.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){vt&&Mt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,te,at,Tt[0].width,Tt[0].height,rt.depth);for(let ft=0,kt=Tt.length;ft<kt;ft++)if(st=Tt[ft],w.format!==yi)if(xt!==null)if(vt){if(Xt)if(w.layerUpdates.size>0){let ee=zd(st.width,st.height,w.format,w.type);for(let Rt of w.layerUpdates){let ue=st.data.subarray(Rt*ee/st.data.BYTES_PER_ELEMENT,(Rt+1)*ee/st.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ft,0,0,Rt,st.width,st.height,1,xt,ue)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ft,0,0,0,st.width,st.height,rt.depth,xt,st.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ft,at,st.width,st.height,rt.depth,0,st.data,0,0);else Jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else vt?Xt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ft,0,0,0,st.width,st.height,rt.depth,xt,B,st.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ft,at,st.width,st.height,rt.depth,0,xt,B,st.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{vt&&Mt&&e.texStorage2D(i.TEXTURE_2D,te,at,Tt[0].width,Tt[0].height);for(let ft=0,kt=Tt.length;ft<kt;ft++)st=Tt[ft],w.format!==yi?xt!==null?vt?Xt&&e.compressedTexSubImage2D(i.TEXTURE_2D,ft,0,0,st.width,st.height,xt,st.data):e.compressedTexImage2D(i.TEXTURE_2D,ft,at,st.width,st.height,0,st.data):Jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):vt?Xt&&e.texSubImage2D(i.TEXTURE_2D,ft,0,0,st.width,st.height,xt,B,st.data):e.texImage2D(i.TEXTURE_2D,ft,at,st.width,st.height,0,xt,B,st.data)}else if(w.isDataArrayTexture)if(vt){if(Mt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,te,at,rt.width,rt.height,rt.depth),Xt)if(w.layerUpdates.size>0){let ft=zd(rt.width,rt.height,w.format,w.type);for(let kt of w.layerUpdates){let ee=rt.data.subarray(kt*ft/rt.data.BYTES_PER_ELEMENT,(kt+1)*ft/rt.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,kt,rt.width,rt.height,1,xt,B,ee)}w.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,rt.width,rt.height,rt.depth,xt,B,rt.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,at,rt.width,rt.height,rt.depth,0,xt,B,rt.data);else if(w.isData3DTexture)vt?(Mt&&e.texStorage3D(i.TEXTURE_3D,te,at,rt.width,rt.height,rt.depth),Xt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,rt.width,rt.height,rt.depth,xt,B,rt.data)):e.texImage3D(i.TEXTURE_3D,0,at,rt.width,rt.height,rt.depth,0,xt,B,rt.data);else if(w.isFramebufferTexture){if(Mt)if(vt)e.texStorage2D(i.TEXTURE_2D,te,at,rt.width,rt.height);else{let ft=rt.width,kt=rt.height;for(let ee=0;ee<te;ee++)e.texImage2D(i.TEXTURE_2D,ee,at,ft,kt,0,xt,B,null),ft>>=1,kt>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in i){let ft=i.canvas;if(ft.hasAttribute("layoutsubtree")||ft.setAttribute("layoutsubtree","true"),rt.parentNode!==ft){ft.appendChild(rt),d.add(w),ft.onpaint=kt=>{let ee=kt.changedElements;for(let Rt of d)ee.includes(Rt.image)&&(Rt.needsUpdate=!0)},ft.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,rt);else{let ee=i.RGBA,Rt=i.RGBA,ue=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,ee,Rt,ue,rt)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Tt.length>0){if(vt&&Mt){let ft=Zt(Tt[0]);e.texStorage2D(i.TEXTURE_2D,te,at,ft.width,ft.height)}for(let ft=0,kt=Tt.length;ft<kt;ft++)st=Tt[ft],vt?Xt&&e.texSubImage2D(i.TEXTURE_2D,ft,0,0,xt,B,st):e.texImage2D(i.TEXTURE_2D,ft,at,xt,B,st);w.generateMipmaps=!1}else if(vt){if(Mt){let ft=Zt(rt);e.texStorage2D(i.TEXTURE_2D,te,at,ft.width,ft.height)}Xt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,xt,B,rt)}else e.texImage2D(i.TEXTURE_2D,0,at,xt,B,rt);R(w)&&w.mipmapsAutoUpdate===!0&&S(mt),St.__version=yt.version,w.onUpdate&&w.onUpdate(w)}L.__version=w.version}function Ke(L,w,Z){if(w.image.length!==6)return;let mt=he(L,w),ct=w.source;e.bindTexture(i.TEXTURE_CUBE_MAP,L.__webglTexture,i.TEXTURE0+Z);let yt=n.get(ct);if(ct.version!==yt.__version||mt===!0){e.activeTexture(i.TEXTURE0+Z);let St=Se.getPrimaries(Se.workingColorSpace),it=w.colorSpace===Cs?null:Se.getPrimaries(w.colorSpace),rt=w.colorSpace===Cs||St===it?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,rt);let xt=w.isCompressedTexture||w.image[0].isCompressedTexture,B=w.image[0]&&w.image[0].isDataTexture,at=[];for(let Rt=0;Rt<6;Rt++)!xt&&!B?at[Rt]=v(w.image[Rt],!0,s.maxCubemapSize):at[Rt]=B?w.image[Rt].image:w.image[Rt],at[Rt]=Wt(w,at[Rt]);let st=at[0],Tt=r.convert(w.format,w.colorSpace),vt=r.convert(w.type),Mt=M(w.internalFormat,Tt,vt,w.normalized,w.colorSpace),Xt=w.isVideoTexture!==!0,te=yt.__version===void 0||mt===!0,ft=ct.dataReady,kt=b(w,st);oe(i.TEXTURE_CUBE_MAP,w);let ee;if(w.isDepthTexture){if(Mt=_(w.format===Rs,w.type),te)if(Xt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,Mt,st.width,st.height);else for(let Rt=0;Rt<6;Rt++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,Mt,st.width,st.height,0,Tt,vt,null)}else if(xt){Xt&&te&&e.texStorage2D(i.TEXTURE_CUBE_MAP,kt,Mt,st.width,st.height);for(let Rt=0;Rt<6;Rt++){ee=at[Rt].mipmaps;for(let ue=0;ue<ee.length;ue++){let Ge=ee[ue];w.format!==yi?Tt!==null?Xt?ft&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue,0,0,Ge.width,Ge.height,Tt,Ge.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue,Mt,Ge.width,Ge.height,0,Ge.data):Jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xt?ft&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue,0,0,Ge.width,Ge.height,Tt,vt,Ge.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue,Mt,Ge.width,Ge.height,0,Tt,vt,Ge.data)}}}else{if(ee=w.mipmaps,Xt&&te){ee.length>0&&kt++;let Rt=Zt(at[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,kt,Mt,Rt.width,Rt.height)}for(let Rt=0;Rt<6;Rt++)if(B){Xt?ft&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,at[Rt].width,at[Rt].height,Tt,vt,at[Rt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,Mt,at[Rt].width,at[Rt].height,0,Tt,vt,at[Rt].data);for(let ue=0;ue<ee.length;ue++){let $n=ee[ue].image[Rt].image;Xt?ft&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue+1,0,0,$n.width,$n.height,Tt,vt,$n.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue+1,Mt,$n.width,$n.height,0,Tt,vt,$n.data)}}else{Xt?ft&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,Tt,vt,at[Rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,Mt,Tt,vt,at[Rt]);for(let ue=0;ue<ee.length;ue++){let Ge=ee[ue];Xt?ft&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue+1,0,0,Tt,vt,Ge.image[Rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue+1,Mt,Tt,vt,Ge.image[Rt])}}}R(w)&&w.mipmapsAutoUpdate===!0&&S(i.TEXTURE_CUBE_MAP),yt.__version=ct.version,w.onUpdate&&w.onUpdate(w)}L.__version=w.version}function Ue(L,w,Z,mt,ct,yt){let St=r.convert(Z.format,Z.colorSpace),it=r.convert(Z.type),rt=M(Z.internalFormat,St,it,Z.normalized,Z.colorSpace),xt=n.get(w),B=n.get(Z);if(B.__renderTarget=w,!xt.__hasExternalTextures){let at=Math.max(1,w.width>>yt),st=Math.max(1,w.height>>yt);ct===i.TEXTURE_3D||ct===i.TEXTURE_2D_ARRAY?e.texImage3D(ct,yt,rt,at,st,w.depth,0,St,it,null):e.texImage2D(ct,yt,rt,at,st,0,St,it,null)}e.bindFramebuffer(i.FRAMEBUFFER,L),wt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,ct,B.__webglTexture,0,ce(w)):(ct===i.TEXTURE_2D||ct>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ct<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,mt,ct,B.__webglTexture,yt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function bn(L,w,Z){if(i.bindRenderbuffer(i.RENDERBUFFER,L),w.depthBuffer){let mt=w.depthTexture,ct=mt&&mt.isDepthTexture?mt.type:null,yt=_(w.stencilBuffer,ct),St=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;wt(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ce(w),yt,w.width,w.height):Z?i.renderbufferStorageMultisample(i.RENDERBUFFER,ce(w),yt,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,yt,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,St,i.RENDERBUFFER,L)}else{let mt=w.textures;for(let ct=0;ct<mt.length;ct++){let yt=mt[ct],St=r.convert(yt.format,yt.colorSpace),it=r.convert(yt.type),rt=M(yt.internalFormat,St,it,yt.normalized,yt.colorSpace);wt(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ce(w),rt,w.width,w.height):Z?i.renderbufferStorageMultisample(i.RENDERBUFFER,ce(w),rt,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,rt,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function be(L,w,Z){let mt=w.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,L),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ct=n.get(w.depthTexture);ct.__renderTarget=w;let yt=mt?w.depthTexture.image[0]:w.depthTexture.image;(!ct.__webglTexture||yt.width!==w.width||yt.height!==w.height)&&(yt.width=w.width,yt.height=w.height,w.depthTexture.needsUpdate=!0),mt?pt(w.depthTexture,0):ut(w.depthTexture,0);let St=ct.__webglTexture,it=ce(w),rt=mt?i.TEXTURE_CUBE_MAP_POSITIVE_X+Z:i.TEXTURE_2D,xt=w.depthTexture.format===Rs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(w.depthTexture.format===bs)wt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,xt,rt,St,0,it):i.framebufferTexture2D(i.FRAMEBUFFER,xt,rt,St,0);else if(w.depthTexture.format===Rs)wt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,xt,rt,St,0,it):i.framebufferTexture2D(i.FRAMEBUFFER,xt,rt,St,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function pn(L){let w=n.get(L),Z=L.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==L.depthTexture){let mt=L.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),mt){let ct=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,mt.removeEventListener("dispose",ct)};mt.addEventListener("dispose",ct),w.__depthDisposeCallback=ct}w.__boundDepthTexture=mt}if(L.depthTexture&&!w.__autoAllocateDepthBuffer)if(Z)for(let mt=0;mt<6;mt++)be(w.__webglFramebuffer[mt],L,mt);else L.texture.mipmaps.length>0?be(w.__webglFramebuffer[0],L,0):be(w.__webglFramebuffer,L,0);else if(Z){w.__webglDepthbuffer=[];for(let mt=0;mt<6;mt++)if(e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[mt]),w.__webglDepthbuffer[mt]===void 0)w.__webglDepthbuffer[mt]=i.createRenderbuffer(),bn(w.__webglDepthbuffer[mt],L,!1);else{let ct=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=w.__webglDepthbuffer[mt];i.bindRenderbuffer(i.RENDERBUFFER,yt),i.framebufferRenderbuffer(i.FRAMEBUFFER,ct,i.RENDERBUFFER,yt)}}else if(L.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),bn(w.__webglDepthbuffer,L,!1);else{let ct=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,yt),i.framebufferRenderbuffer(i.FRAMEBUFFER,ct,i.RENDERBUFFER,yt)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function je(L,w,Z){let mt=n.get(L);w!==void 0&&Ue(mt.__webglFramebuffer,L,L.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Z!==void 0&&pn(L)}function an(L){let w=L.texture,Z=n.get(L),mt=n.get(w);L.addEventListener("dispose",D),F(L);let ct=L.textures,yt=L.isWebGLCubeRenderTarget===!0,St=ct.length>1;if(St||(mt.__webglTexture===void 0&&(mt.__webglTexture=i.createTexture()),mt.__version=w.version,o.memory.textures++),yt){Z.__webglFramebuffer=[];for(let it=0;it<6;it++)if(w.mipmaps.length>0){Z.__webglFramebuffer[it]=[];for(let rt=0;rt<w.mipmaps.length;rt++)Z.__webglFramebuffer[it][rt]=i.createFramebuffer()}else Z.__webglFramebuffer[it]=i.createFramebuffer()}else{if(w.mipmaps.length>0){Z.__webglFramebuffer=[];for(let it=0;it<w.mipmaps.length;it++)Z.__webglFramebuffer[it]=i.createFramebuffer()}else Z.__webglFramebuffer=i.createFramebuffer();if(St)for(let it=0,rt=ct.length;it<rt;it++){let xt=n.get(ct[it]);xt.__webglTexture===void 0&&(xt.__webglTexture=i.createTexture(),o.memory.textures++)}if(L.samples>0&&wt(L)===!1){Z.__webglMultisampledFramebuffer=i.createFramebuffer(),Z.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,Z.__webglMultisampledFramebuffer);for(let it=0;it<ct.length;it++){let rt=ct[it];Z.__webglColorRenderbuffer[it]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Z.__webglColorRenderbuffer[it]);let xt=r.convert(rt.format,rt.colorSpace),B=r.convert(rt.type),at=M(rt.internalFormat,xt,B,rt.normalized,rt.colorSpace,L.isXRRenderTarget===!0),st=ce(L);i.renderbufferStorageMultisample(i.RENDERBUFFER,st,at,L.width,L.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+it,i.RENDERBUFFER,Z.__webglColorRenderbuffer[it])}i.bindRenderbuffer(i.RENDERBUFFER,null),L.depthBuffer&&(Z.__webglDepthRenderbuffer=i.createRenderbuffer(),bn(Z.__webglDepthRenderbuffer,L,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(yt){e.bindTexture(i.TEXTURE_CUBE_MAP,mt.__webglTexture),oe(i.TEXTURE_CUBE_MAP,w);for(let it=0;it<6;it++)if(w.mipmaps.length>0)for(let rt=0;rt<w.mipmaps.length;rt++)Ue(Z.__webglFramebuffer[it][rt],L,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+it,rt);else Ue(Z.__webglFramebuffer[it],L,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+it,0);R(w)?S(i.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}else if(St){for(let it=0,rt=ct.length;it<rt;it++){let xt=ct[it],B=n.get(xt),at=i.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(at=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(at,B.__webglTexture),oe(at,xt),Ue(Z.__webglFramebuffer,L,xt,i.COLOR_ATTACHMENT0+it,at,0),R(xt)&&S(at)}e.unbindTexture()}else{let it=i.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(it=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(it,mt.__webglTexture),oe(it,w),w.mipmaps.length>0)for(let rt=0;rt<w.mipmaps.length;rt++)Ue(Z.__webglFramebuffer[rt],L,w,i.COLOR_ATTACHMENT0,it,rt);else Ue(Z.__webglFramebuffer,L,w,i.COLOR_ATTACHMENT0,it,0);R(w)?S(it):w.mipmaps.length>0&&i.texParameteri(it,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}L.depthBuffer&&pn(L)}function k(L){let w=L.textures;for(let Z=0,mt=w.length;Z<mt;Z++){let ct=w[Z];if(R(ct)&&ct.mipmapsAutoUpdate===!0){let yt=C(L),St=n.get(ct).__webglTexture;e.bindTexture(yt,St),S(yt),e.unbindTexture()}}}let Ct=[];function Kt(L){if(L.samples>0){if(wt(L)===!1){let w=L.textures,Z=L.width,mt=L.height,ct=i.COLOR_BUFFER_BIT,yt=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,St=n.get(L),it=w.length>1;if(it)for(let xt=0;xt<w.length;xt++)e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+xt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+xt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let xt=0;xt<w.length;xt++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(ct|=i.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(ct|=i.STENCIL_BUFFER_BIT)),it){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,St.__webglColorRenderbuffer[xt]);let B=n.get(w[xt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,B,0)}i.blitFramebuffer(0,0,Z,mt,0,0,Z,mt,ct,i.NEAREST),c===!0&&(Ct.length=0,Ct.push(i.COLOR_ATTACHMENT0+xt),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&Ct.push(yt),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ct))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),it)for(let xt=0;xt<w.length;xt++){e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+xt,i.RENDERBUFFER,St.__webglColorRenderbuffer[xt]);let B=n.get(w[xt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+xt,i.TEXTURE_2D,B,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&c){let w=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function ce(L){return Math.min(s.maxSamples,L.samples)}function wt(L){let w=n.get(L);return L.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Oe(L){let w=o.render.frame;h.get(L)!==w&&(h.set(L,w),L.update())}function Wt(L,w){let Z=L.colorSpace,mt=L.format,ct=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||Z!==da&&Z!==Cs&&(Se.getTransfer(Z)===Ie?(mt!==yi||ct!==oi)&&Jt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):se("WebGLTextures: Unsupported texture color space:",Z)),w}function Zt(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(l.width=L.naturalWidth||L.width,l.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(l.width=L.displayWidth,l.height=L.displayHeight):(l.width=L.width,l.height=L.height),l}this.allocateTextureUnit=lt,this.resetTextureUnits=J,this.getTextureUnits=G,this.setTextureUnits=nt,this.setTexture2D=ut,this.setTexture2DArray=dt,this.setTexture3D=gt,this.setTextureCube=pt,this.rebindTextures=je,this.setupRenderTarget=an,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=Kt,this.setupDepthRenderbuffer=pn,this.setupFrameBufferTexture=Ue,this.useMultisampledRTT=wt,this.dispose=V}function K1(i,t){function e(n,s=Cs){let r,o=Se.getTransfer(s);if(n===oi)return i.UNSIGNED_BYTE;if(n===Nc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Uc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Td)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Ed)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Md)return i.BYTE;if(n===wd)return i.SHORT;if(n===Io)return i.UNSIGNED_SHORT;if(n===Dc)return i.INT;if(n===zi)return i.UNSIGNED_INT;if(n===Ri)return i.FLOAT;if(n===Vi)return i.HALF_FLOAT;if(n===Ad)return i.ALPHA;if(n===Rd)return i.RGB;if(n===yi)return i.RGBA;if(n===bs)return i.DEPTH_COMPONENT;if(n===Rs)return i.DEPTH_STENCIL;if(n===Fc)return i.RED;if(n===Oc)return i.RED_INTEGER;if(n===er)return i.RG;if(n===Bc)return i.RG_INTEGER;if(n===kc)return i.RGBA_INTEGER;if(n===Fa||n===Oa||n===Ba||n===ka)if(o===Ie)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Fa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Oa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ba)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===ka)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Fa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Oa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ba)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===ka)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===zc||n===Vc||n===Gc||n===Hc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===zc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Vc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Gc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Hc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Wc||n===Xc||n===qc||n===Yc||n===$c||n===za||n===Zc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Wc||n===Xc)return o===Ie?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===qc)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Yc)return r.COMPRESSED_R11_EAC;if(n===$c)return r.COMPRESSED_SIGNED_R11_EAC;if(n===za)return r.COMPRESSED_RG11_EAC;if(n===Zc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Jc||n===Kc||n===jc||n===Qc||n===th||n===eh||n===nh||n===ih||n===sh||n===rh||n===oh||n===ah||n===lh||n===ch)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Jc)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Kc)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===jc)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Qc)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===th)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===eh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===nh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===ih)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===sh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===rh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===oh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===ah)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===lh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===ch)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===hh||n===uh||n===dh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===hh)return o===Ie?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===uh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===dh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===fh||n===ph||n===Va||n===mh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===fh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===ph)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Va)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===mh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Tr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var j1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Q1=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Zd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new wa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new ts({vertexShader:j1,fragmentShader:Q1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new qn(new yr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Jd=class extends ki{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,h=null,d=null,u=null,f=null,p=null,y=typeof XRWebGLBinding<"u",m=new Zd,g={},v=e.getContextAttributes(),R=null,S=null,C=[],M=[],_=new ne,b=null,F=null,A=new ti;A.viewport=new Ze;let P=new ti;P.viewport=new Ze;let D=[A,P],O=new Rc,I=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(j){let ut=C[j];return ut===void 0&&(ut=new So,C[j]=ut),ut.getTargetRaySpace()},this.getControllerGrip=function(j){let ut=C[j];return ut===void 0&&(ut=new So,C[j]=ut),ut.getGripSpace()},this.getHand=function(j){let ut=C[j];return ut===void 0&&(ut=new So,C[j]=ut),ut.getHandSpace()};function H(j){let ut=M.indexOf(j.inputSource);if(ut===-1)return;let dt=C[ut];dt!==void 0&&(dt.update(j.inputSource,j.frame,l||o),dt.dispatchEvent({type:j.type,data:j.inputSource}))}function z(){s.removeEventListener("select",H),s.removeEventListener("selectstart",H),s.removeEventListener("selectend",H),s.removeEventListener("squeeze",H),s.removeEventListener("squeezestart",H),s.removeEventListener("squeezeend",H),s.removeEventListener("end",z),s.removeEventListener("inputsourceschange",ot);for(let j=0;j<C.length;j++){let ut=M[j];ut!==null&&(M[j]=null,C[j].disconnect(ut))}I=null,V=null,m.reset();for(let j in g)delete g[j];if(t.setRenderTarget(R),f=null,u=null,d=null,s=null,S=null,lt.stop(),n.isPresenting=!1,t.setPixelRatio(b),t.setSize(_.width,_.height,!1),F!==null){let j=F.camera;j.fov=F.fov,j.zoom=F.zoom,j.updateProjectionMatrix(),F=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(j){r=j,n.isPresenting===!0&&Jt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(j){a=j,n.isPresenting===!0&&Jt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(j){l=j},this.getBaseLayer=function(){return u!==null?u:f},this.getBinding=function(){return d===null&&y&&(d=new XRWebGLBinding(s,e)),d},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(j){if(s=j,s!==null){if(R=t.getRenderTarget(),s.addEventListener("select",H),s.addEventListener("selectstart",H),s.addEventListener("selectend",H),s.addEventListener("squeeze",H),s.addEventListener("squeezestart",H),s.addEventListener("squeezeend",H),s.addEventListener("end",z),s.addEventListener("inputsourceschange",ot),v.xrCompatible!==!0&&await e.makeXRCompatible(),b=t.getPixelRatio(),t.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let dt=null,gt=null,pt=null;v.depth&&(pt=v.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,dt=v.stencil?Rs:bs,gt=v.stencil?Tr:zi);let Dt={colorFormat:e.RGBA8,depthFormat:pt,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(Dt),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),S=new xi(u.textureWidth,u.textureHeight,{format:yi,type:oi,depthTexture:new Es(u.textureWidth,u.textureHeight,gt,void 0,void 0,void 0,void 0,void 0,void 0,dt),stencilBuffer:v.stencil,colorSpace:t.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let dt={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,dt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),S=new xi(f.framebufferWidth,f.framebufferHeight,{format:yi,type:oi,colorSpace:t.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),lt.setContext(s),lt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ot(j){for(let ut=0;ut<j.removed.length;ut++){let dt=j.removed[ut],gt=M.indexOf(dt);gt>=0&&(M[gt]=null,C[gt].disconnect(dt))}for(let ut=0;ut<j.added.length;ut++){let dt=j.added[ut],gt=M.indexOf(dt);if(gt===-1){for(let Dt=0;Dt<C.length;Dt++)if(Dt>=M.length){M.push(dt),gt=Dt;break}else if(M[Dt]===null){M[Dt]=dt,gt=Dt;break}if(gt===-1)break}let pt=C[gt];pt&&pt.connect(dt)}}function Y(j,ut){ut===null?j.matrixWorld.copy(j.matrix):j.matrixWorld.multiplyMatrices(ut.matrixWorld,j.matrix),j.matrixWorldInverse.copy(j.matrixWorld).invert()}this.updateCamera=function(j){if(s===null)return;let ut=j.near,dt=j.far;m.texture!==null&&(m.depthNear>0&&(ut=m.depthNear),m.depthFar>0&&(dt=m.depthFar)),O.near=P.near=A.near=ut,O.far=P.far=A.far=dt,(I!==O.near||V!==O.far)&&(s.updateRenderState({depthNear:O.near,depthFar:O.far}),I=O.near,V=O.far),O.layers.mask=j.layers.mask|6,A.layers.mask=O.layers.mask&-5,P.layers.mask=O.layers.mask&-3;let gt=j.parent,pt=O.cameras;Y(O,gt);for(let Dt=0;Dt<pt.length;Dt++)Y(pt[Dt],gt);O.projectionMatrix.copy(A.projectionMatrix),O.projectionMatrixInverse.copy(A.projectionMatrixInverse),F===null&&j.isPerspectiveCamera&&(F={camera:j,fov:j.fov,zoom:j.zoom}),J(j,O,gt)};function J(j,ut,dt){dt===null?j.matrix.copy(ut.matrixWorld):(j.matrix.copy(dt.matrixWorld),j.matrix.invert(),j.matrix.multiply(ut.matrixWorld)),j.matrix.decompose(j.position,j.quaternion,j.scale),j.updateMatrixWorld(!0),j.projectionMatrix.copy(ut.projectionMatrix),j.projectionMatrixInverse.copy(ut.projectionMatrixInverse),j.isPerspectiveCamera&&(j.fov=vo*2*Math.atan(1/j.projectionMatrix.elements[5]),j.zoom=1)}this.getCamera=function(){return O},this.getFoveation=function(){if(!(u===null&&f===null))return c},this.setFoveation=function(j){c=j,u!==null&&(u.fixedFoveation=j),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=j)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(O)},this.getCameraTexture=function(j){return g[j]};let G=null;function nt(j,ut){if(h=ut.getViewerPose(l||o),p=ut,h!==null){let dt=h.views;f!==null&&(t.setRenderTargetFramebuffer(S,f.framebuffer),t.setRenderTarget(S));let gt=!1;dt.length!==O.cameras.length&&(O.cameras.length=0,gt=!0);for(let Ft=0;Ft<dt.length;Ft++){let oe=dt[Ft],he=null;if(f!==null)he=f.getViewport(oe);else{let Ve=d.getViewSubImage(u,oe);he=Ve.viewport,Ft===0&&(t.setRenderTargetTextures(S,Ve.colorTexture,Ve.depthStencilTexture),t.setRenderTarget(S))}let Qt=D[Ft];Qt===void 0&&(Qt=new ti,Qt.layers.enable(Ft),Qt.viewport=new Ze,D[Ft]=Qt),Qt.matrix.fromArray(oe.transform.matrix),Qt.matrix.decompose(Qt.position,Qt.quaternion,Qt.scale),Qt.projectionMatrix.fromArray(oe.projectionMatrix),Qt.projectionMatrixInverse.copy(Qt.projectionMatrix).invert(),Qt.viewport.set(he.x,he.y,he.width,he.height),Ft===0&&(O.matrix.copy(Qt.matrix),O.matrix.decompose(O.position,O.quaternion,O.scale)),gt===!0&&O.cameras.push(Qt)}let pt=s.enabledFeatures;if(pt&&pt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){d=n.getBinding();let Ft=d.getDepthInformation(dt[0]);Ft&&Ft.isValid&&Ft.texture&&m.init(Ft,s.renderState)}if(pt&&pt.includes("camera-access")&&y){t.state.unbindTexture(),d=n.getBinding();for(let Ft=0;Ft<dt.length;Ft++){let oe=dt[Ft].camera;if(oe){let he=g[oe];he||(he=new wa,g[oe]=he);let Qt=d.getCameraImage(oe);he.sourceTexture=Qt}}}}for(let dt=0;dt<C.length;dt++){let gt=M[dt],pt=C[dt];gt!==null&&pt!==void 0&&pt.update(gt,ut,l||o)}G&&G(j,ut),ut.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ut}),p=null}let lt=new S0;lt.setAnimationLoop(nt),this.setAnimationLoop=function(j){G=j},this.dispose=function(){}}},tT=new Ae,I0=new re;I0.set(-1,0,0,0,1,0,0,0,1);function eT(i,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,Od(i)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,v,R,S){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),d(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),u(m,g),g.isMeshPhysicalMaterial&&f(m,g,S)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),y(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?c(m,g,v,R):g.isSpriteMaterial?l(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===ni&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===ni&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let v=t.get(g),R=v.envMap,S=v.envMapRotation;R&&(m.envMap.value=R,m.envMapRotation.value.setFromMatrix4(tT.makeRotationFromEuler(S)).transpose(),R.isCubeTexture&&R.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(I0),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function c(m,g,v,R){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*v,m.scale.value=R*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function l(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function d(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function u(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,v){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===ni&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function y(m,g){let v=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function nT(i,t,e,n){let s={},r={};function o(v,R){let S=R.program;n.uniformBlockBinding(v,S,s[v.id])}function a(v,R){let S=s[v.id];S===void 0&&(p(v),S=c(v),s[v.id]=S,v.addEventListener("dispose",m));let C=R.program;n.updateUBOMapping(v,C);let M=t.render.frame;r[v.id]!==M&&(l(v),r[v.id]=M)}function c(v){let R=i.createBuffer(),S=v.__size,C=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,R),i.bufferData(i.UNIFORM_BUFFER,S,C),i.bindBuffer(i.UNIFORM_BUFFER,null),R}function l(v){let R=s[v.id],S=v.uniforms,C=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,R);for(let M=0,_=S.length;M<_;M++){let b=S[M];if(Array.isArray(b))for(let F=0,A=b.length;F<A;F++)h(b[F],M,F,C);else h(b,M,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(v,R,S,C){if(u(v,R,S,C)===!0){let M=v.__offset,_=v.value;if(Array.isArray(_)){let b=0;for(let F=0;F<_.length;F++){let A=_[F],P=y(A,!0);d(A,v.__data,b),b+=P.storage/Float32Array.BYTES_PER_ELEMENT}}else d(_,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,M,v.__data)}}function d(v,R,S){typeof v=="number"||typeof v=="boolean"?R[S]=v:v.isMatrix3?(R[S]=v.elements[0],R[S+1]=v.elements[1],R[S+2]=v.elements[2],R[S+3]=0,R[S+4]=v.elements[3],R[S+5]=v.elements[4],R[S+6]=v.elements[5],R[S+7]=0,R[S+8]=v.elements[6],R[S+9]=v.elements[7],R[S+10]=v.elements[8],R[S+11]=0):ArrayBuffer.isView(v)?R.set(v.subarray(0,R.length-S),S):v.toArray(R,S)}function u(v,R,S,C){let M=v.value,_=R+"_"+S;if(Array.isArray(M)){C[_]===void 0&&(C[_]=[]);let b=C[_],F=!1;for(let A=0;A<M.length;A++)f(M[A],b,A)===!0&&(F=!0);return F}return f(M,C,_)}function f(v,R,S){if(R[S]===void 0)return typeof v=="number"||typeof v=="boolean"?R[S]=v:ArrayBuffer.isView(v)?R[S]=v.slice():R[S]=v.clone(),!0;{let C=R[S];if(typeof v=="number"||typeof v=="boolean"){if(C!==v)return R[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(C.equals(v)===!1)return C.copy(v),!0}}return!1}function p(v){let R=v.uniforms,S=0,C=16;for(let _=0,b=R.length;_<b;_++){let F=Array.isArray(R[_])?R[_]:[R[_]];for(let A=0,P=F.length;A<P;A++){let D=F[A],O=Array.isArray(D.value)?D.value:[D.value],I=Array.isArray(R[_])||Array.isArray(D.value),V=S;for(let z=0,ot=O.length;z<ot;z++){let Y=O[z],J=y(Y,I),G=S%C,nt=G%J.boundary,lt=G+nt;S+=nt,lt!==0&&C-lt<J.storage&&(S+=C-lt),z===0&&(V=S),S+=J.storage}let H=D.type==="int"?Int32Array:D.type==="uint"?Uint32Array:Float32Array;D.__data=new H((S-V)/Float32Array.BYTES_PER_ELEMENT),D.__offset=V}}let M=S%C;return M>0&&(S+=C-M),v.__size=S,v.__cache={},this}function y(v,R){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?Jt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):Jt("WebGLRenderer: Unsupported uniform value type.",v),R===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function m(v){let R=v.target;R.removeEventListener("dispose",m),i.deleteBuffer(s[R.id]),delete s[R.id],delete r[R.id]}function g(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:g}}var iT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ns=null;function sT(){return ns===null&&(ns=new vr(iT,16,16,er,Vi),ns.name="DFG_LUT",ns.minFilter=Un,ns.magFilter=Un,ns.wrapS=ji,ns.wrapT=ji,ns.generateMipmaps=!1,ns.needsUpdate=!0),ns}var bh=class{constructor(t={}){let{canvas:e=Wg(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:f=oi}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let y=f,m=new Set([kc,Bc,Oc]),g=new Set([oi,zi,Io,Tr,Nc,Uc]),v=new Uint32Array(4),R=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},C=null,M=null,_=[],b=[],F=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=es,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let A=this,P=!1,D=null,O=null,I=null,V=null;this._outputColorSpace=Hn;let H=0,z=0,ot=null,Y=-1,J=null,G=new Ze,nt=new Ze,lt=null,j=new pe(0),ut=0,dt=e.width,gt=e.height,pt=1,Dt=null,qt=null,Ft=new Ze(0,0,dt,gt),oe=new Ze(0,0,dt,gt),he=!1,Qt=new Ys,Ve=new hc,Ce=!1,Ke=!1,Ue=new Ae,bn=new $,be=new Ze,pn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},je=!1;function an(){return ot===null?pt:1}let k=n;function Ct(E,W){return e.getContext(E,W)}let Kt,ce,wt,Oe,Wt,Zt,L,w,Z,mt,ct,yt,St,it,rt,xt,B,at,st,Tt,vt,Mt,Xt;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",kt,!1),e.addEventListener("webglcontextrestored",ee,!1),e.addEventListener("webglcontextcreationerror",Rt,!1),k===null){let W="webgl2";if(k=Ct(W,E),k===null)throw Ct(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}te()}catch(E){throw e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",ee,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),se("WebGLRenderer: "+E.message),E}function te(){Kt=new mw(k),Kt.init(),vt=new K1(k,Kt),ce=new sw(k,Kt,t,vt),wt=new Z1(k,Kt),ce.reversedDepthBuffer&&u&&wt.buffers.depth.setReversed(!0),O=k.createFramebuffer(),I=k.createFramebuffer(),V=k.createFramebuffer(),Oe=new xw(k),Wt=new U1,Zt=new J1(k,Kt,wt,Wt,ce,vt,Oe),L=new pw(A),w=new yS(k),Mt=new nw(k,w),Z=new gw(k,w,Oe,Mt),mt=new yw(k,Z,w,Mt,Oe),at=new vw(k,ce,Zt),rt=new rw(Wt),ct=new N1(A,L,Kt,ce,Mt,rt),yt=new eT(A,Wt),St=new O1,it=new H1(Kt),B=new ew(A,L,wt,mt,p,c),xt=new $1(A,mt,ce),Xt=new nT(k,Oe,ce,wt),st=new iw(k,Kt,Oe),Tt=new _w(k,Kt,Oe),Oe.programs=ct.programs,A.capabilities=ce,A.extensions=Kt,A.properties=Wt,A.renderLists=St,A.shadowMap=xt,A.state=wt,A.info=Oe}y!==oi&&(F=new bw(y,e.width,e.height,a,s,r));let ft=new Jd(A,k);this.xr=ft,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let E=Kt.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=Kt.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return pt},this.setPixelRatio=function(E){E!==void 0&&(pt=E,this.setSize(dt,gt,!1))},this.getSize=function(E){return E.set(dt,gt)},this.setSize=function(E,W,et=!0){if(ft.isPresenting){Jt("WebGLRenderer: Can't change size while VR device is presenting.");return}dt=E,gt=W,e.width=Math.floor(E*pt),e.height=Math.floor(W*pt),et===!0&&(e.style.width=E+"px",e.style.height=W+"px"),F!==null&&F.setSize(e.width,e.height),this.setViewport(0,0,E,W)},this.getDrawingBufferSize=function(E){return E.set(dt*pt,gt*pt).floor()},this.setDrawingBufferSize=function(E,W,et){dt=E,gt=W,pt=et,e.width=Math.floor(E*et),e.height=Math.floor(W*et),this.setViewport(0,0,E,W)},this.setEffects=function(E){if(y===oi){se("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let W=0;W<E.length;W++)if(E[W].isOutputPass===!0){Jt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}F.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(G)},this.getViewport=function(E){return E.copy(Ft)},this.setViewport=function(E,W,et,K){E.isVector4?Ft.set(E.x,E.y,E.z,E.w):Ft.set(E,W,et,K),wt.viewport(G.copy(Ft).multiplyScalar(an()).round())},this.getScissor=function(E){return E.copy(oe)},this.setScissor=function(E,W,et,K){E.isVector4?oe.set(E.x,E.y,E.z,E.w):oe.set(E,W,et,K),wt.scissor(nt.copy(oe).multiplyScalar(an()).round())},this.getScissorTest=function(){return he},this.setScissorTest=function(E){wt.setScissorTest(he=E)},this.setOpaqueSort=function(E){Dt=E},this.setTransparentSort=function(E){qt=E},this.getClearColor=function(E){return E.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(E=!0,W=!0,et=!0){let K=0;if(E){let Q=!1;if(ot!==null){let Et=ot.texture.format;Q=m.has(Et)}if(Q){let Et=ot.texture.type,Pt=g.has(Et),At=B.getClearColor(),It=B.getClearAlpha(),Vt=At.r,ie=At.g,me=At.b;Pt?(v[0]=Vt,v[1]=ie,v[2]=me,v[3]=It,k.clearBufferuiv(k.COLOR,0,v)):(R[0]=Vt,R[1]=ie,R[2]=me,R[3]=It,k.clearBufferiv(k.COLOR,0,R))}else K|=k.COLOR_BUFFER_BIT}W&&(K|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),et&&(K|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),K!==0&&k.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),D=E},this.dispose=function(){e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",ee,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),B.dispose(),St.dispose(),it.dispose(),Zt.dispose(),Wt.dispose(),L.dispose(),mt.dispose(),Z.dispose(),Mt.dispose(),Xt.dispose(),ct.dispose(),ft.dispose(),ft.removeEventListener("sessionstart",qa),ft.removeEventListener("sessionend",Hi),ss.stop()};function kt(E){E.preventDefault(),Dd("WebGLRenderer: Context Lost."),P=!0}function ee(){Dd("WebGLRenderer: Context Restored."),P=!1;let E=Oe.autoReset,W=xt.enabled,et=xt.autoUpdate,K=xt.needsUpdate,Q=xt.type;te(),Oe.autoReset=E,xt.enabled=W,xt.autoUpdate=et,xt.needsUpdate=K,xt.type=Q}function Rt(E){se("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function ue(E){let W=E.target;W.removeEventListener("dispose",ue),Ge(W)}function Ge(E){$n(E),Wt.remove(E)}function $n(E){let W=Wt.get(E).programs;W!==void 0&&(W.forEach(function(et){ct.releaseProgram(et)}),E.isShaderMaterial&&ct.releaseShaderCache(E))}this.renderBufferDirect=function(E,W,et,K,Q,Et){W===null&&(W=pn);let Pt=Q.isMesh&&Q.matrixWorld.determinantAffine()<0,At=ko(E,W,et,K,Q);wt.setMaterial(K,Pt);let It=et.index,Vt=1;if(K.wireframe===!0){if(It=Z.getWireframeAttribute(et),It===void 0)return;Vt=2}let ie=et.drawRange,me=et.attributes.position,zt=ie.start*Vt,ge=(ie.start+ie.count)*Vt;Et!==null&&(zt=Math.max(zt,Et.start*Vt),ge=Math.min(ge,(Et.start+Et.count)*Vt)),It!==null?(zt=Math.max(zt,0),ge=Math.min(ge,It.count)):me!=null&&(zt=Math.max(zt,0),ge=Math.min(ge,me.count));let Je=ge-zt;if(Je<0||Je===1/0)return;Mt.setup(Q,K,At,et,It);let Le,De=st;if(It!==null&&(Le=w.get(It),De=Tt,De.setIndex(Le)),Q.isMesh)K.wireframe===!0?(wt.setLineWidth(K.wireframeLinewidth*an()),De.setMode(k.LINES)):De.setMode(k.TRIANGLES);else if(Q.isLine){let mn=K.linewidth;mn===void 0&&(mn=1),wt.setLineWidth(mn*an()),Q.isLineSegments?De.setMode(k.LINES):Q.isLineLoop?De.setMode(k.LINE_LOOP):De.setMode(k.LINE_STRIP)}else Q.isPoints?De.setMode(k.POINTS):Q.isSprite&&De.setMode(k.TRIANGLES);if(Q.isBatchedMesh)if(Kt.get("WEBGL_multi_draw"))De.renderMultiDraw(Q._multiDrawStarts,Q._multiDrawCounts,Q._multiDrawCount);else{let mn=Q._multiDrawStarts,Ot=Q._multiDrawCounts,ln=Q._multiDrawCount,ve=It?w.get(It).bytesPerElement:1,os=Wt.get(K).currentProgram.getUniforms();for(let cn=0;cn<ln;cn++)os.setValue(k,"_gl_DrawID",cn),De.render(mn[cn]/ve,Ot[cn])}else if(Q.isInstancedMesh)De.renderInstances(zt,Je,Q.count);else if(et.isInstancedBufferGeometry){let mn=et._maxInstanceCount!==void 0?et._maxInstanceCount:1/0,Ot=Math.min(et.instanceCount,mn);De.renderInstances(zt,Je,Ot)}else De.render(zt,Je)};function Fo(E,W,et,K){D!==null&&E.isNodeMaterial&&D.setObject(K,E),Ce===!0&&rt.setState(E,et,!1),E.transparent===!0&&E.side===ri&&E.forceSinglePass===!1?(E.side=ni,E.needsUpdate=!0,Wi(E,W,K),E.side=tr,E.needsUpdate=!0,Wi(E,W,K),E.side=ri):Wi(E,W,K)}this.compile=function(E,W,et=null){et===null&&(et=E),D!==null&&D.renderStart(E,W,et),M=it.get(et),M.init(W),b.push(M),et.traverseVisible(function(Q){Q.isLight&&Q.layers.test(W.layers)&&(M.pushLight(Q),Q.castShadow&&M.pushShadow(Q))}),E!==et&&E.traverseVisible(function(Q){Q.isLight&&Q.layers.test(W.layers)&&(M.pushLight(Q),Q.castShadow&&M.pushShadow(Q))}),M.setupLights(),D!==null&&D.updateLights(M.state.lightsArray),Ke=this.localClippingEnabled,Ce=rt.init(this.clippingPlanes,Ke),Ce===!0&&rt.setGlobalState(this.clippingPlanes,W),D!==null&&xt.render(M.state.shadowsArray,et,W);let K=new Set;return E.traverse(function(Q){if(!(Q.isMesh||Q.isPoints||Q.isLine||Q.isSprite))return;let Et=Q.material;if(Et)if(Array.isArray(Et))for(let Pt=0;Pt<Et.length;Pt++){let At=Et[Pt];Fo(At,et,W,Q),K.add(At)}else Fo(Et,et,W,Q),K.add(Et)}),M=b.pop(),D!==null&&D.renderEnd(),K},this.compileAsync=function(E,W,et=null){let K=this.compile(E,W,et);return new Promise(Q=>{function Et(){if(K.forEach(function(Pt){let It=Wt.get(Pt).currentProgram;(It===void 0||It.isReady())&&K.delete(Pt)}),K.size===0){Q(E);return}setTimeout(Et,10)}Kt.get("KHR_parallel_shader_compile")!==null?Et():setTimeout(Et,10)})};let Rr=null;function Ph(E){Rr&&Rr(E)}function qa(){ss.stop()}function Hi(){ss.start()}let ss=new S0;ss.setAnimationLoop(Ph),typeof self<"u"&&ss.setContext(self),this.setAnimationLoop=function(E){Rr=E,ft.setAnimationLoop(E),E===null?ss.stop():ss.start()},ft.addEventListener("sessionstart",qa),ft.addEventListener("sessionend",Hi),this.render=function(E,W){if(W!==void 0&&W.isCamera!==!0){se("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;D!==null&&D.renderStart(E,W);let et=ft.enabled===!0&&ft.isPresenting===!0,K=F!==null&&(ot===null||et)&&F.begin(A,ot);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),ft.enabled===!0&&ft.isPresenting===!0&&(F===null||F.isCompositing()===!1)&&(ft.cameraAutoUpdate===!0&&ft.updateCamera(W),W=ft.getCamera()),E.isScene===!0&&E.onBeforeRender(A,E,W,ot),M=it.get(E,b.length),M.init(W),M.state.textureUnits=Zt.getTextureUnits(),b.push(M),Ue.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),W.isArrayCamera?Ve.setFromArrayCamera(W):Qt.setFromProjectionMatrix(Ue,Ai,W.reversedDepth),Ke=this.localClippingEnabled,Ce=rt.init(this.clippingPlanes,Ke),C=St.get(E,_.length),C.init(),_.push(C),this.info.render.frame++,ft.enabled===!0&&ft.isPresenting===!0){let Pt=A.xr.getDepthSensingMesh();Pt!==null&&rs(Pt,W,-1/0,A.sortObjects)}rs(E,W,0,A.sortObjects),C.finish(),D!==null&&D.updateLights(M.state.lightsArray),A.sortObjects===!0&&C.sort(Dt,qt),je=ft.enabled===!1||ft.isPresenting===!1||ft.hasDepthSensing()===!1,je&&B.addToRenderList(C,E),this.info.autoReset===!0&&this.info.reset(),Ce===!0&&rt.beginShadows();let Q=M.state.shadowsArray;if(xt.render(Q,E,W),Ce===!0&&rt.endShadows(),(K&&F.hasRenderPass())===!1){let Pt=C.opaque,At=C.transmissive;if(M.setupLights(),W.isArrayCamera){let It=W.cameras;if(At.length>0)for(let Vt=0,ie=It.length;Vt<ie;Vt++){let me=It[Vt];Ci(Pt,At,E,me)}je&&B.render(E);for(let Vt=0,ie=It.length;Vt<ie;Vt++){let me=It[Vt];Oo(C,E,me,me.viewport)}}else At.length>0&&Ci(Pt,At,E,W),je&&B.render(E),Oo(C,E,W)}ot!==null&&z===0&&(Zt.updateMultisampleRenderTarget(ot),Zt.updateRenderTargetMipmap(ot)),K&&F.end(A),E.isScene===!0&&E.onAfterRender(A,E,W),Mt.resetDefaultState(),Y=-1,J=null,b.pop(),b.length>0?(M=b[b.length-1],Zt.setTextureUnits(M.state.textureUnits),Ce===!0&&rt.setGlobalState(A.clippingPlanes,M.state.camera)):M=null,_.pop(),_.length>0?C=_[_.length-1]:C=null,D!==null&&D.renderEnd()};function rs(E,W,et,K){if(E.visible===!1)return;if(E.layers.test(W.layers)){if(E.isGroup)et=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(W);else if(E.isLight)M.pushLight(E),E.castShadow&&M.pushShadow(E);else if(E.isSprite){let Pt=W.isArrayCamera?Ve:Qt;if(!E.frustumCulled||E.intersectsFrustum(Pt)){K&&be.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Ue);let At=mt.update(E),It=E.material;It.visible&&C.push(E,At,It,et,be.z,null,W)}}else if(E.isMesh||E.isLine||E.isPoints){let Pt=W.isArrayCamera?Ve:Qt;if(!E.frustumCulled||E.intersectsFrustum(Pt)){let At=mt.update(E),It=E.material;if(K&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),be.copy(E.boundingSphere.center)):(At.boundingSphere===null&&At.computeBoundingSphere(),be.copy(At.boundingSphere.center)),be.applyMatrix4(E.matrixWorld).applyMatrix4(Ue)),Array.isArray(It)){let Vt=At.groups;for(let ie=0,me=Vt.length;ie<me;ie++){let zt=Vt[ie],ge=It[zt.materialIndex];ge&&ge.visible&&C.push(E,At,ge,et,be.z,zt,W)}}else It.visible&&C.push(E,At,It,et,be.z,null,W)}}}let Et=E.children;for(let Pt=0,At=Et.length;Pt<At;Pt++)rs(Et[Pt],W,et,K)}function Oo(E,W,et,K){let{opaque:Q,transmissive:Et,transparent:Pt}=E;M.setupLightsView(et),Ce===!0&&rt.setGlobalState(A.clippingPlanes,et),K&&wt.viewport(G.copy(K)),Q.length>0&&Qe(Q,W,et),Et.length>0&&Qe(Et,W,et),Pt.length>0&&Qe(Pt,W,et),wt.buffers.depth.setTest(!0),wt.buffers.depth.setMask(!0),wt.buffers.color.setMask(!0),wt.setPolygonOffset(!1)}function Ci(E,W,et,K){if((et.isScene===!0?et.overrideMaterial:null)!==null)return;if(M.state.transmissionRenderTarget[K.id]===void 0){let zt=Kt.has("EXT_color_buffer_half_float")||Kt.has("EXT_color_buffer_float");M.state.transmissionRenderTarget[K.id]=new xi(1,1,{generateMipmaps:!0,type:zt?Vi:oi,minFilter:As,samples:Math.max(4,ce.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Se.workingColorSpace})}let Et=M.state.transmissionRenderTarget[K.id],Pt=K.viewport||G;Et.setSize(Pt.z*A.transmissionResolutionScale,Pt.w*A.transmissionResolutionScale);let At=A.getRenderTarget(),It=A.getActiveCubeFace(),Vt=A.getActiveMipmapLevel();A.setRenderTarget(Et),A.getClearColor(j),ut=A.getClearAlpha(),ut<1&&A.setClearColor(16777215,.5),A.clear(),je&&B.render(et);let ie=A.toneMapping;A.toneMapping=es;let me=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),M.setupLightsView(K),Ce===!0&&rt.setGlobalState(A.clippingPlanes,K),Qe(E,et,K),Zt.updateMultisampleRenderTarget(Et),Zt.updateRenderTargetMipmap(Et),Kt.has("WEBGL_multisampled_render_to_texture")===!1){let zt=!1;for(let ge=0,Je=W.length;ge<Je;ge++){let Le=W[ge],{object:De,geometry:mn,material:Ot,group:ln}=Le;if(Ot.side===ri&&De.layers.test(K.layers)){let ve=Ot.side;Ot.side=ni,Ot.needsUpdate=!0,sn(De,et,K,mn,Ot,ln),Ot.side=ve,Ot.needsUpdate=!0,zt=!0}}zt===!0&&(Zt.updateMultisampleRenderTarget(Et),Zt.updateRenderTargetMipmap(Et))}A.setRenderTarget(At,It,Vt),A.setClearColor(j,ut),me!==void 0&&(K.viewport=me),A.toneMapping=ie}function Qe(E,W,et){let K=W.isScene===!0?W.overrideMaterial:null;for(let Q=0,Et=E.length;Q<Et;Q++){let Pt=E[Q],{object:At,geometry:It,group:Vt}=Pt,ie=Pt.material;ie.allowOverride===!0&&K!==null&&(ie=K),At.layers.test(et.layers)&&sn(At,W,et,It,ie,Vt)}}function sn(E,W,et,K,Q,Et){D!==null&&Q.isNodeMaterial&&D.setObject(E,Q),E.onBeforeRender(A,W,et,K,Q,Et),E.modelViewMatrix.multiplyMatrices(et.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),Q.onBeforeRender(A,W,et,K,E,Et),Q.transparent===!0&&Q.side===ri&&Q.forceSinglePass===!1?(Q.side=ni,Q.needsUpdate=!0,A.renderBufferDirect(et,W,K,Q,E,Et),Q.side=tr,Q.needsUpdate=!0,A.renderBufferDirect(et,W,K,Q,E,Et),Q.side=ri):A.renderBufferDirect(et,W,K,Q,E,Et),E.onAfterRender(A,W,et,K,Q,Et)}function rn(E){let W=0;for(let et of E)et.texture!==null&&W++;return W}function Wi(E,W,et){W.isScene!==!0&&(W=pn);let K=Wt.get(E),Q=M.state.lights,Et=M.state.shadowsArray,Pt=Q.state.version,At=ct.getParameters(E,Q.state,Et,W,et,M.state.lightProbeGridArray),It=ct.getProgramCacheKey(At),Vt=K.programs;K.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?W.environment:null,K.fog=W.fog;let ie=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;K.envMap=L.get(E.envMap||K.environment,ie),K.envMapRotation=K.environment!==null&&E.envMap===null?W.environmentRotation:E.envMapRotation,Vt===void 0&&(E.addEventListener("dispose",ue),Vt=new Map,K.programs=Vt,K.programVariants=new Map);let me=Vt.get(It);if(me!==void 0){if(K.currentProgram===me&&K.lightsStateVersion===Pt)return Bo(E,At),me}else At.uniforms=ct.getUniforms(E),D!==null&&E.isNodeMaterial&&D.build(E,et,At),E.onBeforeCompile(At,A),me=ct.acquireProgram(At,It),Vt.set(It,me),K.uniforms=At.uniforms;let zt=K.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(zt.clippingPlanes=rt.uniform),Bo(E,At),K.needsLights=Is(E),K.lightsStateVersion=Pt,K.needsLights&&(zt.ambientLightColor.value=Q.state.ambient,zt.lightProbe.value=Q.state.probe,zt.sunLights.value=Q.state.sun,zt.sunLightShadows.value=Q.state.sunShadow,zt.directionalLights.value=Q.state.directional,zt.directionalLightShadows.value=Q.state.directionalShadow,zt.spotLights.value=Q.state.spot,zt.spotLightShadows.value=Q.state.spotShadow,zt.rectAreaLights.value=Q.state.rectArea,zt.ltc_1.value=Q.state.rectAreaLTC1,zt.ltc_2.value=Q.state.rectAreaLTC2,zt.pointLights.value=Q.state.point,zt.pointLightShadows.value=Q.state.pointShadow,zt.hemisphereLights.value=Q.state.hemi,zt.sunShadowMatrix.value=Q.state.sunShadowMatrix,zt.sunShadowCascade.value=Q.state.sunShadowCascade,zt.directionalShadowMatrix.value=Q.state.directionalShadowMatrix,zt.spotLightMatrix.value=Q.state.spotLightMatrix,zt.spotLightMap.value=Q.state.spotLightMap,zt.pointShadowMatrix.value=Q.state.pointShadowMatrix),K.numLightProbeGrids=rn(M.state.lightProbeGridArray),K.currentProgram=me,K.uniformsList=null,me}function li(E,W,et,K,Q){let Et=Wt.get(E),Pt=Et.currentProgram.id+","+K+","+Q,At=Et.programVariants.get(Pt);return At===void 0?(At=Wi(E,W,et),Et.programVariants.set(Pt,At)):(Et.currentProgram=At,Et.uniformsList=null,Et.outputColorSpace=K,Et.toneMapping=Q),At}function Ps(E){if(E.uniformsList===null){let W=E.currentProgram.getUniforms();E.uniformsList=Do.seqWithValue(W.seq,E.uniforms)}return E.uniformsList}function Bo(E,W){let et=Wt.get(E);et.outputColorSpace=W.outputColorSpace,et.batching=W.batching,et.batchingColor=W.batchingColor,et.instancing=W.instancing,et.instancingColor=W.instancingColor,et.instancingMorph=W.instancingMorph,et.skinning=W.skinning,et.morphTargets=W.morphTargets,et.morphNormals=W.morphNormals,et.morphColors=W.morphColors,et.morphTargetsCount=W.morphTargetsCount,et.numClippingPlanes=W.numClippingPlanes,et.numIntersection=W.numClipIntersection,et.vertexAlphas=W.vertexAlphas,et.vertexTangents=W.vertexTangents,et.toneMapping=W.toneMapping}function ko(E,W,et,K,Q){W.isScene!==!0&&(W=pn),Zt.resetTextureUnits();let Et=W.fog,Pt=K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial?W.environment:null,At=ot===null?A.outputColorSpace:ot.isXRRenderTarget===!0?ot.texture.colorSpace:Se.workingColorSpace,It=K.isMeshStandardMaterial||K.isMeshLambertMaterial&&!K.envMap||K.isMeshPhongMaterial&&!K.envMap,Vt=L.get(K.envMap||Pt,It),ie=K.vertexColors===!0&&!!et.attributes.color&&et.attributes.color.itemSize===4,me=!!et.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),zt=!!et.morphAttributes.position,ge=!!et.morphAttributes.normal,Je=!!et.morphAttributes.color,Le=es;K.toneMapped&&(ot===null||ot.isXRRenderTarget===!0)&&(Le=A.toneMapping);let De=et.morphAttributes.position||et.morphAttributes.normal||et.morphAttributes.color,mn=De!==void 0?De.length:0,Ot=Wt.get(K),ln=M.state.lights;if(Ce===!0&&(Ke===!0||E!==J)){let Ne=E===J&&K.id===Y;rt.setState(K,E,Ne)}let ve=!1,os=!1;K.version===Ot.__version?Ot.needsLights&&Ot.lightsStateVersion!==ln.state.version||Q.isBatchedMesh&&Ot.batching===!1||!Q.isBatchedMesh&&Ot.batching===!0||Q.isBatchedMesh&&Ot.batchingColor===!0&&Q._colorsTexture===null||Q.isBatchedMesh&&Ot.batchingColor===!1&&Q._colorsTexture!==null||Q.isInstancedMesh&&Ot.instancing===!1||!Q.isInstancedMesh&&Ot.instancing===!0||Q.isSkinnedMesh&&Ot.skinning===!1||!Q.isSkinnedMesh&&Ot.skinning===!0||Q.isInstancedMesh&&Ot.instancingColor===!0&&Q.instanceColor===null||Q.isInstancedMesh&&Ot.instancingColor===!1&&Q.instanceColor!==null||Q.isInstancedMesh&&Ot.instancingMorph===!0&&Q.morphTexture===null||Q.isInstancedMesh&&Ot.instancingMorph===!1&&Q.morphTexture!==null||Ot.envMap!==Vt||K.fog===!0&&Ot.fog!==Et||Ot.numClippingPlanes!==void 0&&(Ot.numClippingPlanes!==rt.numPlanes||Ot.numIntersection!==rt.numIntersection)||Ot.vertexAlphas!==ie||Ot.vertexTangents!==me||Ot.morphTargets!==zt||Ot.morphNormals!==ge||Ot.morphColors!==Je||Ot.morphTargetsCount!==mn||Ot.numLightProbeGrids!==rn(M.state.lightProbeGridArray)?ve=!0:(Ot.outputColorSpace!==At||Ot.toneMapping!==Le)&&(os=!0):(ve=!0,Ot.__version=K.version);let cn=Ot.currentProgram;(ve===!0||os===!0)&&(cn=os===!0?li(K,W,Q,At,Le):Wi(K,W,Q),D&&K.isNodeMaterial&&D.onUpdateProgram(K,cn,Ot));let Ir=!1,Xi=!1,as=!1,de=cn.getUniforms(),tn=Ot.uniforms;if(wt.useProgram(cn.program)&&(Ir=!0,Xi=!0,as=!0),K.id!==Y&&(Y=K.id,Xi=!0),Ir||J!==E){wt.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),de.setValue(k,"projectionMatrix",E.projectionMatrix),de.setValue(k,"viewMatrix",E.matrixWorldInverse);let hn=de.map.cameraPosition;hn!==void 0&&hn.setValue(k,bn.setFromMatrixPosition(E.matrixWorld)),ce.logarithmicDepthBuffer&&de.setValue(k,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&de.setValue(k,"isOrthographic",E.isOrthographicCamera===!0),J!==E&&(J=E,Xi=!0,as=!0)}if(Ot.needsLights&&(ln.state.sunShadowMap.length>0&&de.setValue(k,"sunShadowMap",ln.state.sunShadowMap,Zt),ln.state.directionalShadowMap.length>0&&de.setValue(k,"directionalShadowMap",ln.state.directionalShadowMap,Zt),ln.state.spotShadowMap.length>0&&de.setValue(k,"spotShadowMap",ln.state.spotShadowMap,Zt),ln.state.pointShadowMap.length>0&&de.setValue(k,"pointShadowMap",ln.state.pointShadowMap,Zt)),Q.isSkinnedMesh){de.setOptional(k,Q,"bindMatrix"),de.setOptional(k,Q,"bindMatrixInverse");let Ne=Q.skeleton;Ne&&(Ne.boneTexture===null&&Ne.computeBoneTexture(),de.setValue(k,"boneTexture",Ne.boneTexture,Zt))}Q.isBatchedMesh&&(de.setOptional(k,Q,"batchingTexture"),de.setValue(k,"batchingTexture",Q._matricesTexture,Zt),de.setOptional(k,Q,"batchingIdTexture"),de.setValue(k,"batchingIdTexture",Q._indirectTexture,Zt),de.setOptional(k,Q,"batchingColorTexture"),Q._colorsTexture!==null&&de.setValue(k,"batchingColorTexture",Q._colorsTexture,Zt));let Zn=et.morphAttributes;if((Zn.position!==void 0||Zn.normal!==void 0||Zn.color!==void 0)&&at.update(Q,et,cn),(Xi||Ot.receiveShadow!==Q.receiveShadow)&&(Ot.receiveShadow=Q.receiveShadow,de.setValue(k,"receiveShadow",Q.receiveShadow)),(K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial)&&K.envMap===null&&W.environment!==null&&(tn.envMapIntensity.value=W.environmentIntensity),tn.dfgLUT!==void 0&&(tn.dfgLUT.value=sT()),Xi){if(de.setValue(k,"toneMappingExposure",A.toneMappingExposure),Ot.needsLights&&Cr(tn,as),Et&&K.fog===!0&&yt.refreshFogUniforms(tn,Et),yt.refreshMaterialUniforms(tn,K,pt,gt,M.state.transmissionRenderTarget[E.id]),Ot.needsLights&&Ot.numLightProbeGrids>0){let Ne=S,hn=0;for(let On of M.state.lightProbeGridArray)On.texture!==null&&(Ne.textures[hn]=On.texture,Ne.min[hn]=On.boundingBox.min,Ne.max[hn]=On.boundingBox.max,Ne.resolution[hn]=On.resolution,hn++);for(let On in Ne)Ne[On].length=hn;tn.probesSH.value=Ne.textures,tn.probesMin.value=Ne.min,tn.probesMax.value=Ne.max,tn.probesResolution.value=Ne.resolution}Do.upload(k,Ps(Ot),tn,Zt)}if(K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(Do.upload(k,Ps(Ot),tn,Zt),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&de.setValue(k,"center",Q.center),de.setValue(k,"modelViewMatrix",Q.modelViewMatrix),de.setValue(k,"normalMatrix",Q.normalMatrix),de.setValue(k,"modelMatrix",Q.matrixWorld),K.uniformsGroups!==void 0){let Ne=K.uniformsGroups;for(let hn=0,On=Ne.length;hn<On;hn++){let Ya=Ne[hn];Xt.update(Ya,cn),Xt.bind(Ya,cn)}}return cn}function Cr(E,W){E.ambientLightColor.needsUpdate=W,E.lightProbe.needsUpdate=W,E.sunLights.needsUpdate=W,E.sunLightShadows.needsUpdate=W,E.directionalLights.needsUpdate=W,E.directionalLightShadows.needsUpdate=W,E.pointLights.needsUpdate=W,E.pointLightShadows.needsUpdate=W,E.spotLights.needsUpdate=W,E.spotLightShadows.needsUpdate=W,E.rectAreaLights.needsUpdate=W,E.hemisphereLights.needsUpdate=W}function Is(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return H},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return ot},this.setRenderTargetTextures=function(E,W,et){let K=Wt.get(E);K.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),Wt.get(E.texture).__webglTexture=W,Wt.get(E.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:et,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,W){let et=Wt.get(E);et.__webglFramebuffer=W,et.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(E,W=0,et=0){ot=E,H=W,z=et;let K=null,Q=!1,Et=!1;if(E){let At=Wt.get(E);if(At.__useDefaultFramebuffer!==void 0){wt.bindFramebuffer(k.FRAMEBUFFER,At.__webglFramebuffer),G.copy(E.viewport),nt.copy(E.scissor),lt=E.scissorTest,wt.viewport(G),wt.scissor(nt),wt.setScissorTest(lt),Y=-1;return}else if(At.__webglFramebuffer===void 0)Zt.setupRenderTarget(E);else if(At.__hasExternalTextures)Zt.rebindTextures(E,Wt.get(E.texture).__webglTexture,Wt.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let ie=E.depthTexture;if(At.__boundDepthTexture!==ie){if(ie!==null&&Wt.has(ie)&&(E.width!==ie.image.width||E.height!==ie.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Zt.setupDepthRenderbuffer(E)}}let It=E.texture;(It.isData3DTexture||It.isDataArrayTexture||It.isCompressedArrayTexture)&&(Et=!0);let Vt=Wt.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Vt[W])?K=Vt[W][et]:K=Vt[W],Q=!0):E.samples>0&&Zt.useMultisampledRTT(E)===!1?K=Wt.get(E).__webglMultisampledFramebuffer:Array.isArray(Vt)?K=Vt[et]:K=Vt,G.copy(E.viewport),nt.copy(E.scissor),lt=E.scissorTest}else G.copy(Ft).multiplyScalar(pt).floor(),nt.copy(oe).multiplyScalar(pt).floor(),lt=he;if(et!==0&&(K=O),wt.bindFramebuffer(k.FRAMEBUFFER,K)&&wt.drawBuffers(E,K),wt.viewport(G),wt.scissor(nt),wt.setScissorTest(lt),Q){let At=Wt.get(E.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+W,At.__webglTexture,et)}else if(Et){let At=W;for(let It=0;It<E.textures.length;It++){let Vt=Wt.get(E.textures[It]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+It,Vt.__webglTexture,et,At)}}else if(E!==null&&et!==0){let At=Wt.get(E.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,At.__webglTexture,et)}Y=-1};function Pr(E){let W=Wt.get(E);return(W.__readFormat!==E.format||W.__readType!==E.type)&&(W.__readFormat=E.format,W.__readType=E.type,W.__formatReadable=ce.textureFormatReadable(E.format),W.__typeReadable=ce.textureTypeReadable(E.type)),W}this.readRenderTargetPixels=function(E,W,et,K,Q,Et,Pt,At=0){if(!(E&&E.isWebGLRenderTarget)){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let It=Wt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It){wt.bindFramebuffer(k.FRAMEBUFFER,It);try{let Vt=E.textures[At],ie=Vt.format,me=Vt.type;E.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+At);let zt=Pr(Vt);if(zt.__formatReadable===!1){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(zt.__typeReadable===!1){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=E.width-K&&et>=0&&et<=E.height-Q&&k.readPixels(W,et,K,Q,vt.convert(ie),vt.convert(me),Et)}finally{let Vt=ot!==null?Wt.get(ot).__webglFramebuffer:null;wt.bindFramebuffer(k.FRAMEBUFFER,Vt)}}},this.readRenderTargetPixelsAsync=async function(E,W,et,K,Q,Et,Pt,At=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let It=Wt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It)if(W>=0&&W<=E.width-K&&et>=0&&et<=E.height-Q){wt.bindFramebuffer(k.FRAMEBUFFER,It);let Vt=E.textures[At],ie=Vt.format,me=Vt.type;E.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+At);let zt=Pr(Vt);if(zt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(zt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ge=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,ge),k.bufferData(k.PIXEL_PACK_BUFFER,Et.byteLength,k.STREAM_READ),k.readPixels(W,et,K,Q,vt.convert(ie),vt.convert(me),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let Je=ot!==null?Wt.get(ot).__webglFramebuffer:null;wt.bindFramebuffer(k.FRAMEBUFFER,Je);let Le=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await qg(k,Le,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,ge),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Et),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(ge),k.deleteSync(Le),Et}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,W=null,et=0){let K=Math.pow(2,-et),Q=Math.floor(E.image.width*K),Et=Math.floor(E.image.height*K),Pt=W!==null?W.x:0,At=W!==null?W.y:0;Zt.setTexture2D(E,0),k.copyTexSubImage2D(k.TEXTURE_2D,et,0,0,Pt,At,Q,Et),wt.unbindTexture()},this.copyTextureToTexture=function(E,W,et=null,K=null,Q=0,Et=0){let Pt,At,It,Vt,ie,me,zt,ge,Je,Le=E.isCompressedTexture?E.mipmaps[Et]:E.image;if(et!==null)Pt=et.max.x-et.min.x,At=et.max.y-et.min.y,It=et.isBox3?et.max.z-et.min.z:1,Vt=et.min.x,ie=et.min.y,me=et.isBox3?et.min.z:0;else{let de=Math.pow(2,-Q);Pt=Math.floor(Le.width*de),At=Math.floor(Le.height*de),E.isDataArrayTexture?It=Le.depth:E.isData3DTexture?It=Math.floor(Le.depth*de):It=1,Vt=0,ie=0,me=0}K!==null?(zt=K.x,ge=K.y,Je=K.z):(zt=0,ge=0,Je=0);let De=vt.convert(W.format),mn=vt.convert(W.type),Ot;W.isData3DTexture?(Zt.setTexture3D(W,0),Ot=k.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?(Zt.setTexture2DArray(W,0),Ot=k.TEXTURE_2D_ARRAY):(Zt.setTexture2D(W,0),Ot=k.TEXTURE_2D),wt.activeTexture(k.TEXTURE0),wt.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,W.flipY),wt.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),wt.pixelStorei(k.UNPACK_ALIGNMENT,W.unpackAlignment);let ln=wt.getParameter(k.UNPACK_ROW_LENGTH),ve=wt.getParameter(k.UNPACK_IMAGE_HEIGHT),os=wt.getParameter(k.UNPACK_SKIP_PIXELS),cn=wt.getParameter(k.UNPACK_SKIP_ROWS),Ir=wt.getParameter(k.UNPACK_SKIP_IMAGES);wt.pixelStorei(k.UNPACK_ROW_LENGTH,Le.width),wt.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Le.height),wt.pixelStorei(k.UNPACK_SKIP_PIXELS,Vt),wt.pixelStorei(k.UNPACK_SKIP_ROWS,ie),wt.pixelStorei(k.UNPACK_SKIP_IMAGES,me);let Xi=E.isDataArrayTexture||E.isData3DTexture,as=W.isDataArrayTexture||W.isData3DTexture;if(E.isDepthTexture){let de=Wt.get(E),tn=Wt.get(W),Zn=Wt.get(de.__renderTarget),Ne=Wt.get(tn.__renderTarget);wt.bindFramebuffer(k.READ_FRAMEBUFFER,Zn.__webglFramebuffer),wt.bindFramebuffer(k.DRAW_FRAMEBUFFER,Ne.__webglFramebuffer);for(let hn=0;hn<It;hn++)Xi&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Wt.get(E).__webglTexture,Q,me+hn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Wt.get(W).__webglTexture,Et,Je+hn)),k.blitFramebuffer(Vt,ie,Vt+Pt,ie+At,zt,ge,zt+Pt,ge+At,k.DEPTH_BUFFER_BIT,k.NEAREST);wt.bindFramebuffer(k.READ_FRAMEBUFFER,null),wt.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(Q!==0||E.isRenderTargetTexture||Wt.has(E)){let de=Wt.get(E),tn=Wt.get(W);wt.bindFramebuffer(k.READ_FRAMEBUFFER,I),wt.bindFramebuffer(k.DRAW_FRAMEBUFFER,V);for(let Zn=0;Zn<It;Zn++)Xi?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,de.__webglTexture,Q,me+Zn):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,de.__webglTexture,Q),as?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,tn.__webglTexture,Et,Je+Zn):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,tn.__webglTexture,Et),Q!==0?k.blitFramebuffer(Vt,ie,Vt+Pt,ie+At,zt,ge,zt+Pt,ge+At,k.COLOR_BUFFER_BIT,k.NEAREST):as?k.copyTexSubImage3D(Ot,Et,zt,ge,Je+Zn,Vt,ie,Pt,At):k.copyTexSubImage2D(Ot,Et,zt,ge,Vt,ie,Pt,At);wt.bindFramebuffer(k.READ_FRAMEBUFFER,null),wt.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else as?E.isDataTexture||E.isData3DTexture?k.texSubImage3D(Ot,Et,zt,ge,Je,Pt,At,It,De,mn,Le.data):W.isCompressedArrayTexture?k.compressedTexSubImage3D(Ot,Et,zt,ge,Je,Pt,At,It,De,Le.data):k.texSubImage3D(Ot,Et,zt,ge,Je,Pt,At,It,De,mn,Le):E.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Et,zt,ge,Pt,At,De,mn,Le.data):E.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Et,zt,ge,Le.width,Le.height,De,Le.data):k.texSubImage2D(k.TEXTURE_2D,Et,zt,ge,Pt,At,De,mn,Le);wt.pixelStorei(k.UNPACK_ROW_LENGTH,ln),wt.pixelStorei(k.UNPACK_IMAGE_HEIGHT,ve),wt.pixelStorei(k.UNPACK_SKIP_PIXELS,os),wt.pixelStorei(k.UNPACK_SKIP_ROWS,cn),wt.pixelStorei(k.UNPACK_SKIP_IMAGES,Ir),Et===0&&W.generateMipmaps===!0&&W.mipmapsAutoUpdate===!0&&k.generateMipmap(Ot),wt.unbindTexture()},this.initRenderTarget=function(E){Wt.get(E).__webglFramebuffer===void 0&&Zt.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Zt.setTextureCube(E,0):E.isData3DTexture?Zt.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Zt.setTexture2DArray(E,0):Zt.setTexture2D(E,0),wt.unbindTexture()},this.resetState=function(){H=0,z=0,ot=null,wt.reset(),Mt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ai}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Se._getDrawingBufferColorSpace(t),e.unpackColorSpace=Se._getUnpackColorSpace()}};var L0={type:"change"},jd={type:"start"},N0={type:"end"},Th=new xr,D0=new _i,rT=Math.cos(70*xh.DEG2RAD),Sn=new $,ai=2*Math.PI,Re={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Kd=1e-6,Eh=class extends Da{constructor(t,e=null){super(t,e),this.state=Re.NONE,this.target=new $,this.cursor=new $,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:js.ROTATE,MIDDLE:js.DOLLY,RIGHT:js.PAN},this.touches={ONE:Qs.ROTATE,TWO:Qs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new $,this._lastQuaternion=new ei,this._lastTargetPosition=new $,this._quat=new ei().setFromUnitVectors(t.up,new $(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ao,this._sphericalDelta=new Ao,this._scale=1,this._panOffset=new $,this._rotateStart=new ne,this._rotateEnd=new ne,this._rotateDelta=new ne,this._panStart=new ne,this._panEnd=new ne,this._panDelta=new ne,this._dollyStart=new ne,this._dollyEnd=new ne,this._dollyDelta=new ne,this._dollyDirection=new $,this._mouse=new ne,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=aT.bind(this),this._onPointerDown=oT.bind(this),this._onPointerUp=lT.bind(this),this._onContextMenu=mT.bind(this),this._onMouseWheel=uT.bind(this),this._onKeyDown=dT.bind(this),this._onTouchStart=fT.bind(this),this._onTouchMove=pT.bind(this),this._onMouseDown=cT.bind(this),this._onMouseMove=hT.bind(this),this._interceptControlDown=gT.bind(this),this._interceptControlUp=_T.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Re.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(L0),this.update(),this.state=Re.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Sn.copy(e).sub(this.target),Sn.applyQuaternion(this._quat),this._spherical.setFromVector3(Sn),this.autoRotate&&this.state===Re.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=ai:n>Math.PI&&(n-=ai),s<-Math.PI?s+=ai:s>Math.PI&&(s-=ai),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Sn.setFromSpherical(this._spherical),Sn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Sn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Sn.length();o=this._clampDistance(a*this._scale);let c=a-o;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),r=!!c}else if(this.object.isOrthographicCamera){let a=new $(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=c!==this.object.zoom;let l=new $(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(a),this.object.updateMatrixWorld(),o=Sn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Th.origin.copy(this.object.position),Th.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Th.direction))<rT?this.object.lookAt(this.target):(D0.setFromNormalAndCoplanarPoint(this.object.up,this.target),Th.intersectPlane(D0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Kd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Kd||this._lastTargetPosition.distanceToSquared(this.target)>Kd?(this.dispatchEvent(L0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ai/60*this.autoRotateSpeed*t:ai/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Sn.setFromMatrixColumn(e,0),Sn.multiplyScalar(-t),this._panOffset.add(Sn)}_panUp(t,e){this.screenSpacePanning===!0?Sn.setFromMatrixColumn(e,1):(Sn.setFromMatrixColumn(e,0),Sn.crossVectors(this.object.up,Sn)),Sn.multiplyScalar(t),this._panOffset.add(Sn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Sn.copy(s).sub(this.target);let r=Sn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ai*this._rotateDelta.x/e.clientHeight),this._rotateUp(ai*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ai*this._rotateDelta.x/e.clientHeight),this._rotateUp(ai*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new ne,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function oT(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function aT(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function lT(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(N0),this.state=Re.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function cT(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case js.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Re.DOLLY;break;case js.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Re.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Re.ROTATE}break;case js.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Re.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Re.PAN}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(jd)}function hT(i){switch(this.state){case Re.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Re.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Re.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function uT(i){this.enabled===!1||this.enableZoom===!1||this.state!==Re.NONE||(i.preventDefault(),this.dispatchEvent(jd),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(N0))}function dT(i){this.enabled!==!1&&this._handleKeyDown(i)}function fT(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Qs.ROTATE:if(this.enableRotate===!1){this.state=Re.NONE;break}this._handleTouchStartRotate(i),this.state=Re.TOUCH_ROTATE;break;case Qs.PAN:if(this.enablePan===!1){this.state=Re.NONE;break}this._handleTouchStartPan(i),this.state=Re.TOUCH_PAN;break;default:this.state=Re.NONE}break;case 2:switch(this.touches.TWO){case Qs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Re.TOUCH_DOLLY_PAN;break;case Qs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Re.TOUCH_DOLLY_ROTATE;break;default:this.state=Re.NONE}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(jd)}function pT(i){switch(this._trackPointer(i),this.state){case Re.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Re.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Re.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Re.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Re.NONE}}function mT(i){this.enabled!==!1&&i.preventDefault()}function gT(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function _T(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function F0(i,t=!1){let e=i[0].index!==null,n=new Set(Object.keys(i[0].attributes)),s=new Set(Object.keys(i[0].morphAttributes)),r={},o={},a=i[0].morphTargetsRelative,c=new Fn;c.morphTargetsRelative=a;let l=0;for(let h=0;h<i.length;++h){let d=i[h],u=0,f=0;if(e!==(d.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in d.attributes){if(!n.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(d.attributes[p]),u++}if(u!==n.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of attributes."),null;if(a!==d.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in d.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+".  .morphAttributes must be consistent throughout all geometries."),null;if(d.morphAttributes[p].length!==i[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(d.morphAttributes[p]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of morph attributes."),null;if(t){let p;if(e)p=d.index.count;else if(d.attributes.position!==void 0)p=d.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". The geometry must have either an index or a position attribute"),null;c.addGroup(l,p,h),l+=p}}if(e){let h=0,d=[];for(let u=0;u<i.length;++u){let f=i[u].index;for(let p=0;p<f.count;++p)d.push(f.getX(p)+h);h+=i[u].attributes.position.count}c.setIndex(d)}for(let h in r){let d=U0(r[h]);if(!d)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" attribute."),null;c.setAttribute(h,d)}for(let h in o){let d=o[h][0].length;if(d!==0){c.morphAttributes=c.morphAttributes||{},c.morphAttributes[h]=[];for(let u=0;u<d;++u){let f=[];for(let y=0;y<o[h].length;++y)f.push(o[h][y][u]);let p=U0(f);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" morphAttribute."),null;c.morphAttributes[h].push(p)}}}return c}function U0(i){let t,e,n,s=-1,r=0;for(let l=0;l<i.length;++l){let h=i[l];if(t===void 0&&(t=h.array.constructor),t!==h.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=h.itemSize),e!==h.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(n===void 0&&(n=h.normalized),n!==h.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=h.gpuType),s!==h.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=h.count*e}let o=new t(r),a=new Wn(o,e,n),c=0;for(let l=0;l<i.length;++l){let h=i[l];if(h.isInterleavedBufferAttribute){let d=c/e;for(let u=0,f=h.count;u<f;u++)for(let p=0;p<e;p++){let y=h.getComponent(u,p);a.setComponent(u+d,p,y)}}else o.set(h.array,c);c+=h.count*e}return s!==void 0&&(a.gpuType=s),a}var Qd=new $(0,1,0),Ah=Math.PI/24,xT=new $(.7,.5,1.22).normalize(),vT=1.08;function yT(){let i=new To(.035,.035,.7,6).translate(0,-.15,0),t=new Ta(.11,.3,8).translate(0,.35,0),e=F0([i,t]);return i.dispose(),t.dispose(),e}var Rh=class{constructor(){this.canvas=q("canvas",{class:"space",tabindex:"0",role:"img","aria-label":"Velocity vectors in space; arrow keys turn them, plus and minus zoom"}),this.labels=["x","y","z"].map(e=>q("span",{class:"axis-label","aria-hidden":"true"},e)),this.element=q("div",{class:"space-frame"},this.canvas,...this.labels),this.renderer=new bh({canvas:this.canvas,antialias:!0,alpha:!0}),this.scene=new _a,this.camera=new ti(35,1,.1,1e3),this.camera.up.set(0,1,0),this.controls=new Eh(this.camera,this.canvas),this.controls.enableDamping=!1,this.controls.addEventListener("change",()=>this.draw()),this.canvas.addEventListener("keydown",e=>this.key(e)),new ResizeObserver(()=>this.draw()).observe(this.canvas),this.scene.add(new La(16777215,1.6));let t=new Ia(16777215,2.2);this.camera.add(t),t.position.set(1,2,3),this.scene.add(this.camera),this.group=new ys,this.scene.add(this.group),this.box=new Sa(new Fn,new wo),this.group.add(this.box),this.vectorMaterial=new Sr,this.arrow=yT(),this.vectors=null,this.surface=new qn(new Fn,new Sr({side:ri,transparent:!0,opacity:.6,depthWrite:!1})),this.surface.visible=!1,this.group.add(this.surface),this.bodies=new qn(new Fn,new Sr({side:ri,transparent:!0,opacity:.45,depthWrite:!1})),this.bodies.visible=!1,this.drawnMask=null,this.group.add(this.bodies),this.slice=new qn(new yr(1,1),new bo({side:ri,transparent:!0,opacity:.7})),this.slice.visible=!1,this.group.add(this.slice),this.size=null,this.isFramed=!1}key(t){let e={ArrowLeft:[-Ah,0],ArrowRight:[Ah,0],ArrowUp:[0,-Ah],ArrowDown:[0,Ah]},n={"+":.9,"=":.9,"-":1/.9};if(e[t.key])this.turn(...e[t.key]);else if(n[t.key])this.camera.position.multiplyScalar(n[t.key]);else return;t.preventDefault(),this.controls.update(),this.draw()}turn(t,e){let{position:n}=this.camera;n.applyAxisAngle(Qd,t);let s=new $().crossVectors(Qd,n).normalize(),r=n.clone().applyAxisAngle(s,e);Math.abs(r.clone().normalize().y)<.99&&n.copy(r),this.camera.lookAt(0,0,0)}frame(t){this.shot=t.shot;let e=t.n.map(s=>s*t.spacing);if(this.size&&e.every((s,r)=>s===this.size[r]))return;this.size=e,this.box.geometry.dispose();let n=new $s(...e);this.box.geometry=new Ea(n),n.dispose(),this.isFramed=!1}standBack(){let t=this.camera.fov/2*(Math.PI/180),e=Math.min(t,Math.atan(Math.tan(t)*this.camera.aspect)),n=Math.hypot(...this.size)/2;this.camera.position.copy(xT).multiplyScalar(vT*n/Math.sin(e)),this.isFramed=!0,this.controls.target.set(0,0,0),this.controls.update()}place(t,e,n,s){return new $(...[e,n,s].map((r,o)=>(r-(t.n[o]-1)/2)*t.spacing))}showVectors(t,e,n,s){let r=t.status.length;(!this.vectors||this.vectors.instanceMatrix.count<r)&&(this.vectors&&(this.group.remove(this.vectors),this.vectors.dispose()),this.vectors=new ya(this.arrow,this.vectorMaterial,r),this.vectors.instanceMatrix.setUsage(_h),this.vectors.frustumCulled=!1,this.group.add(this.vectors)),this.vectors.visible=s;let[o,a,c,l,h]=[new $,new Ae,new ei,new $,new pe],d=1.3*t.spacing,u=0;for(let f=0;f<r;f+=1){o.set(e[3*f],e[3*f+1],e[3*f+2]);let p=o.length();if(!(p>0))continue;let[y,m]=[f%t.n[0],Math.floor(f/t.n[0])%t.n[1]],g=Math.floor(f/(t.n[0]*t.n[1]));c.setFromUnitVectors(Qd,o.divideScalar(p));let v=d*Math.min(1.2,Math.max(.15,p/n.high));l.set(.75*d,v,.75*d),this.vectors.setMatrixAt(u,a.compose(this.place(t,y,m,g),c,l));let[R,S,C]=n.rgb(p);this.vectors.setColorAt(u,h.setRGB(R/255,S/255,C/255,Hn)),u+=1}this.vectors.count=u,this.vectors.instanceMatrix.needsUpdate=!0,this.vectors.instanceColor&&(this.vectors.instanceColor.needsUpdate=!0)}showBodies(t,e){if(this.bodies.visible=!!e,!e||this.drawnMask===e&&this.maskedSize===this.size)return;[this.drawnMask,this.maskedSize]=[e,this.size];let n=t.first.map((a,c)=>a+(t.n[c]-1)/2*t.spacing),s=a=>n.map((c,l)=>c+a*this.size[l]/2),r=Cf(e,s(-1),s(1)).map((a,c)=>a-n[c%3]),{geometry:o}=this.bodies;o.dispose(),o.setAttribute("position",new Wn(r,3)),o.deleteAttribute("normal"),o.computeVertexNormals(),this.bodies.visible=r.length>0}showSurface(t,e){if(this.surface.visible=!!e?.length,!this.surface.visible)return;let{geometry:n}=this.surface,s=n.getAttribute("position");(!s||s.array.length<e.length)&&(n.dispose(),n.setAttribute("position",new Wn(new Float32Array(2*e.length),3).setUsage(_h)),n.deleteAttribute("normal"));let r=n.getAttribute("position");e.forEach((o,a)=>{let c=a%3;r.array[a]=(o-(t.n[c]-1)/2)*t.spacing}),r.needsUpdate=!0,n.setDrawRange(0,e.length/3),n.computeVertexNormals()}showSlice(t,e,n,s,r,o){if(this.slice.visible=!!s,!s)return;let{material:a}=this.slice;(!a.map||a.map.image.width!==r||a.map.image.height!==o)&&(a.map?.dispose(),a.map=new vr(new Uint8Array(4*r*o),r,o,yi),a.map.colorSpace=Hn,a.map.magFilter=Un,a.needsUpdate=!0),a.map.image.data.set(s),a.map.needsUpdate=!0;let{n:c,spacing:l}=t,h=this.place(t,...c.map((y,m)=>m===e?n:(y-1)/2)),[d,u]=[[1,2],[0,2],[0,1]][e],f=y=>new $(...[0,1,2].map(m=>y===m?1:0)),p=new $().crossVectors(f(d),f(u));this.slice.setRotationFromMatrix(new Ae().makeBasis(f(d),f(u),p)),this.slice.position.copy(h),this.slice.scale.set(c[d]*l,c[u]*l,1)}draw(){if(this.canvas.clientWidth===0||!this.size)return;let{width:t,height:e,ratio:n}=Os(this.canvas);this.renderer.setPixelRatio(1),this.renderer.setSize(t,e,!1),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.isFramed||this.standBack(),this.box.material.color.set(Bn("faint-ink")),this.surface.material.color.set(Bn("surface")),this.bodies.material.color.set(Bn("mask")),this.renderer.render(this.scene,this.camera),this.placeLabels(t/n,e/n);let{geometries:s,textures:r}=this.renderer.info.memory;this.canvas.dataset.gpuObjects=String(s+r),this.canvas.dataset.shot=String(this.shot)}placeLabels(t,e){let[n,s,r]=this.size.map(a=>a/2);[new $(0,-s,r),new $(-n,0,r),new $(n,-s,0)].forEach((a,c)=>{let l=this.labels[c];l.textContent=`${"xyz"[c]}  ${Ht(this.size[c])} mm`;let h=a.multiplyScalar(1.12).project(this.camera);l.style.left=`${(h.x+1)/2*t}px`,l.style.top=`${(1-h.y)/2*e}px`})}};var ST=[[0,1,3,7],[0,3,2,7],[0,2,6,7],[0,6,4,7],[0,4,5,7],[0,5,1,7]];function O0(i,t,e){let n=[],s=(r,o)=>r+(o&1)+t[0]*(o>>1&1)+t[0]*t[1]*(o>>2&1);for(let r=0;r+1<t[2];r+=1)for(let o=0;o+1<t[1];o+=1)for(let a=0;a+1<t[0];a+=1){let c=a+t[0]*(o+t[1]*r),l=Array.from({length:8},(h,d)=>i[s(c,d)]);if(!l.some(h=>h!==h))for(let h of ST)bT(h,l,[a,o,r],e,n)}return new Float32Array(n)}function bT(i,t,e,n,s){let r=i.filter(h=>t[h]>=n),o=i.filter(h=>t[h]<n);if(r.length===0||o.length===0)return;let a=(h,d)=>{let u=(n-t[h])/(t[d]-t[h]);return[0,1,2].map(f=>{let[p,y]=[h>>f&1,d>>f&1];return e[f]+p+u*(y-p)})};if(r.length===2){let[h,d]=r,[u,f]=o,[p,y,m,g]=[a(h,u),a(h,f),a(d,f),a(d,u)];s.push(...p,...y,...m,...p,...m,...g);return}let[c,l]=r.length===1?[r[0],o]:[o[0],r];for(let h of l)s.push(...a(c,h))}var B0={shot:"this shot",mean:"mean of the run",rms:"rms of the run"},tf={speed:"speed",u:"u along x",v:"v along y",w:"w along z",vorticity:"|vorticity|",vorticity_x:"vorticity about x",vorticity_y:"vorticity about y",vorticity_z:"vorticity about z",uncertainty:"standard uncertainty"},k0={0:"x",1:"y",2:"z"},ef=.99;function z0(i,t,e){let n={shown:"shot",quantity:"speed",axis:2,index:null,along:0,line:null,level:60},s=new Rh,r=fr(),o=fr(),a=new jr((G,nt)=>P(G,nt)),c=Kr(i,G=>t.hold(G)),l=q("p",{class:"empty"}),h={valid:Gt("Valid vectors"),replaced:Gt("Replaced"),masked:Gt("Masked",{title:"vectors whose place is not flow, as [volume.mask] says; no share counts them"}),speed:Gt("Largest speed",{title:"99th percentile"}),uncertainty:Gt("Uncertainty",{title:"median standard uncertainty of a component"}),shots:Gt("Shots in mean and rms",{title:"all shots of the run so far, their valid vectors"})},d=Fs("Vectors",!0,()=>A()),u=Fs("Vorticity surface",!0,()=>A()),f=Fs("Slice",!0,()=>A()),p=or("Surface at",{max:95,value:n.level},G=>A({level:G})),y=ii("Show",B0,G=>A({shown:G})),m=ii("Colour of the slice",tf,G=>A({quantity:G})),g=ii("Slice across",k0,G=>A({axis:Number(G),index:null,line:null}));g.input.value="2";let v=or("at",{max:1},G=>A({index:G})),R=ii("Profile along",k0,G=>A({along:Number(G),line:null})),S=new zn({x:"position (mm)",y:"velocity (m/s)",alt:"Velocity along the dashed line of the slice",series:[{label:"u"},{label:"v"},{label:"w"}]}),C=[0,1,2].map(G=>new zn({x:`displacement along ${"xyz"[G]} (voxel)`,y:"vectors",height:130,alt:`Histogram of the displacements along ${"xyz"[G]}`,series:[{label:"vectors",kind:"bars"}]})),M=q("p",{class:"hint legend"},q("span",{class:"swatch","aria-hidden":"true"}),"Not flow");M.hidden=!0;let _=q("p",{class:"advice"}),b=q("p",{class:"advice"}),F=q("div",{class:"view velocity"},q("div",{class:"controls"},c.element,y.element,l),q("dl",{class:"readings"},...Object.values(h).map(G=>G.element)),q("div",{class:"two"},Be("In space",s.element,r.element,q("div",{class:"controls"},d.element,u.element,p.element,f.element)),Be("Slice",q("div",{class:"controls"},g.element,v.element,m.element),a.canvas,o.element,M)),q("div",{class:"two"},Be("Profile",q("div",{class:"controls"},R.element,q("p",{class:"hint"},"Press a place in the slice to move the line.")),S.element),Be("Displacements",...C.map(G=>G.element),_,b)));t.watch(()=>A()),e.watch(()=>n.shown!=="shot"&&A());function A(G={}){Object.assign(n,G),F.isConnected&&!F.hidden&&I()}function P(G,nt){let{field:lt}=t;if(!lt)return;let[j,ut]=Ti[n.axis],dt=n.along===ut,[gt,pt]=dt?[G,lt.n[j]]:[nt,lt.n[ut]];n.along===n.axis&&(n.along=j),R.input.value=String(n.along),A({line:Math.min(pt-1,Math.floor(gt*pt))})}function D(G){return n.shown==="shot"?null:(e.want(qo[n.shown]),e.has(qo[n.shown])&&zf(G,e.now)?e.now:null)}function O({u:G,uncertainty:nt},lt){let j=n.quantity;if(j==="speed")return[zr(G),"speed (m/s)",!1];if(j==="uncertainty")return[zr(nt).map(dt=>dt/Math.sqrt(3)),"standard uncertainty of a component (m/s)",!1];if(j==="vorticity")return[zr(lt),"|vorticity| (1/s)",!1];let ut={u:0,v:1,w:2,vorticity_x:0,vorticity_y:1,vorticity_z:2}[j];return j.startsWith("vorticity")?[Zh(lt,ut),`${tf[j]} (1/s)`,!0]:[Zh(G,ut),`${tf[j]} (m/s)`,n.shown!=="rms"]}function I(){let{field:G}=t,nt=G&&D(G),lt=G&&n.shown!=="shot"&&!nt;if($t(l,G?lt?e.error??`The ${B0[n.shown]} is asked for: this is shot ${G.shot}.`:t.error??"":t.error??"No result yet: the first shot that is measured appears here."),F.classList.toggle("without",!G),!G)return;let j=qo[n.shown],ut=nt?{u:qh(nt,j),uncertainty:qh(nt,j,nl)}:G,{u:dt}=ut,gt=Vf(G,dt),pt=zr(dt),Dt=new fs(0,kn(pt,ef));s.frame(G),s.showVectors(G,dt,Dt,d.input.checked),s.showBodies(G,i.mask),r.show(Dt,nt&&n.shown==="rms"?"fluctuation (m/s)":"speed (m/s)");let qt=zr(gt),Ft=kn(qt,.995)*n.level/100;$t(p.shown,`${Ht(Ft)} 1/s`),s.showSurface(G,u.input.checked&&Ft>0?O0(qt,G.n,Ft):null),V(G,ut,gt,Dt),H(G,dt),z(G,ut,pt),h.shots.element.hidden=!nt,h.shots.show(nt?le(nt.shots):"–"),s.draw()}function V(G,nt,lt,j){let ut=G.n[n.axis];n.index=Math.min(ut-1,n.index??Math.floor(ut/2)),v.input.max=ut-1,v.input.value=n.index,$t(v.shown,`${"xyz"[n.axis]} = ${Ht(G.first[n.axis]+n.index*G.spacing,2)} mm`);let[dt,gt,pt]=O(nt,lt),Dt=kn(dt.map(Math.abs),ef),qt=new fs(pt?-Dt:0,Dt,pt);n.along===n.axis&&(n.along=Ti[n.axis][0]),R.input.value=String(n.along);let[Ft,oe]=Ti[n.axis],he=n.along===Ft,Qt=G.n[he?oe:Ft];n.line=Math.min(Qt-1,n.line??Math.floor(Qt/2));let Ve={along:he?0:1,index:n.line};a.draw(G,dt,nt.u,{axis:n.axis,index:n.index,scale:qt,longest:j.high,line:Ve}),o.show(qt,gt);let Ce=Sl(G,dt,n.axis,n.index),Ke=f.input.checked?Lu(Ce,qt):null;s.showSlice(G,n.axis,n.index,Ke,Ce[0].length,Ce.length)}function H(G,nt){let[lt,j]=Ti[n.axis],ut=n.along===lt?j:lt,dt=[],gt=[[],[],[]];for(let pt=0;pt<G.n[n.along];pt+=1){let Dt=[0,0,0];[Dt[n.axis],Dt[n.along],Dt[ut]]=[n.index,pt,n.line];let qt=Dt[0]+G.n[0]*(Dt[1]+G.n[1]*Dt[2]);dt.push(G.first[n.along]+pt*G.spacing),gt.forEach((Ft,oe)=>Ft.push(nt[3*qt+oe]===nt[3*qt+oe]?nt[3*qt+oe]:null))}S.show([dt,...gt])}function z(G,nt,lt){let j=G.status.reduce((gt,pt)=>gt+(pt===1),0),ut=Gf(G);h.valid.show(Cn(ut,1),ut<.7?"doubt":null);let dt=Jh(G);h.replaced.show(Cn(j/Math.max(1,dt),1)),M.hidden=dt===G.status.length,h.masked.show(dt<G.status.length?String(G.status.length-dt):"none"),h.speed.show(`${Ht(kn(lt,ef))} m/s`),h.uncertainty.show(`${Ht(kn(nt.uncertainty,.5),2)} m/s`),C.forEach((gt,pt)=>{let Dt=bl(G,pt),qt=Lm(Dt,Math.min(48,Math.max(8,Math.round(1.5*Math.sqrt(Dt.length)))));gt.show([qt.centres,qt.counts])});for(let[gt,pt]of[[_,Dm(G)],[b,ot(G)]])$t(gt,pt?.text??""),pt?.tone?gt.dataset.tone=pt.tone:delete gt.dataset.tone}function ot(G){let nt=i.status?.configuration.window_mm;return nt?Nm(G,nt):null}let Y=null;function J(){c.update(),i.mask!==Y&&(Y=i.mask,A()),n.shown!=="shot"&&e.want(qo[n.shown])}return{element:F,update:J,show:()=>I()}}var MT="LFPIVPA1",wT=.99,V0={few:3,many:2},TT=3e3,ET=1;async function G0(i){let t=await rr(`/api/v1/results/${i}/particles?format=binary`);return t.byteLength>0?AT(t):null}function AT(i){let t=new DataView(i),e=String.fromCharCode(...new Uint8Array(i,0,8));if(e!==MT)throw new Error(`particles of another version: ${e}`);let[n,s]=[16,20].map(u=>t.getUint32(u,!0)),r=t.getUint32(28,!0),o=t.getFloat64(32,!0)*.001/t.getFloat64(40,!0),a=new Float32Array(i,r+12*n,3*n),c=new Uint8Array(i,r+(36+4*s)*n,n),l=Float32Array.from({length:n},(u,f)=>o*Math.hypot(...a.subarray(3*f,3*f+3))),h=c.reduce((u,f)=>u+f,0),d=new fs(0,kn(l.map((u,f)=>c[f]?u:NaN),wT),!1,Em);return{count:n,at:new Float32Array(i,r,3*n),speed:l,valid:c,accepted:h,scale:d}}function H0(i,{count:t,at:e,speed:n,valid:s,scale:r},[o,a],c,l){let h=(t<TT?V0.few:V0.many)*l,d=(u,f)=>{let[p,y]=c(e[3*u+o],e[3*u+a]);i.fillRect(p-f/2,y-f/2,f,f)};i.fillStyle="#000000";for(let u=0;u<t;u+=1)s[u]&&d(u,h+2*ET*l);for(let u=0;u<t;u+=1)s[u]&&(i.fillStyle=`rgb(${r.rgb(n[u]).join(" ")})`,d(u,h))}var RT={xy:[0,1],xz:[0,2],yz:[1,2]},CT=700,PT=.7,W0="share of the voxels that are flow, as [volume.mask] says";function X0(i){let t={frame:"a",held:null},e=Kr(i,v=>{t.held=v,y()}),n=ii("Frame",{a:"a",b:"b"},v=>{t.frame=v,y()}),s=Fs("Particles",!0,()=>m()),r=fr(),o=q("p",{class:"empty"}),a={size:Gt("Volume"),voxels:Gt("Voxels"),flow:Gt("Flow",{title:W0}),particles:Gt("Particles",{title:"from the statistics of the first measured pair's views"}),perWindow:Gt("Particles per window"),placed:Gt("Particles placed",{title:"seen in the images of both frames; valid: they agree with those about them, and are drawn; none where correlation resolves the flow"}),unexplained:Gt("Light unexplained",{title:"per camera; 0: everything is explained"}),agreement:Gt("Cameras agree",{title:"correlation of the cameras' light along the direction that both see"}),disparity:Gt("Cameras apart")},c=q("p",{class:"hint legend"},q("span",{class:"swatch","aria-hidden":"true"}),"Not flow: the deeper the tint, the more of the line of sight. There is light in it, but no vector is measured, and no particle is placed in a volume with a mask."),l=Object.entries(RT).map(([v,R])=>IT(v,R)),h=q("div",{class:"view volume"},q("div",{class:"controls"},e.element,n.element,s.element,o),q("dl",{class:"readings"},...Object.values(a).map(v=>v.element)),c,q("div",{class:"three"},...l.map(v=>v.element)),r.element);for(let v of[c,s.element,a.placed.element,r.element])v.hidden=!0;let d=null,u=null,f=!1,p=-1/0;async function y(){if(f||h.hidden||document.hidden||!i.status)return;let v=t.held??i.latestResult;if(v===null){$t(o,"No result yet.");return}f=!0,p=performance.now();try{let{configuration:R}=i.status,[S,C]=await Promise.allSettled([Promise.all(l.map(M=>Ka(`/api/v1/results/${v}/projections/${t.frame}/${M.name}.png`))),R.place_particles?G0(v):null]);if(u=C.value??null,!S.value&&!u)throw S.reason;l.forEach((M,_)=>M.show(S.value?.[_].bitmap??null,R,i.mask)),m(),d=`${v} ${t.frame}`,$t(o,(S.reason??C.reason)?.message??"")}catch(R){$t(o,R instanceof on?R.message:"the daemon does not answer")}finally{f=!1}}function m(){l.forEach(v=>v.particles(s.input.checked?u:null)),r.element.hidden=!(u&&s.input.checked),a.placed.show(u?`${le(u.count)}, ${le(u.accepted)} valid`:"–"),u&&r.show(u.scale,"speed of the particles (m/s)")}function g(){e.update();let{status:v}=i;if(!v)return;s.element.hidden=a.placed.element.hidden=!v.configuration.place_particles;let{voxels_xyz:R,voxel_mm:S}=v.configuration;a.size.show(`${R.map(A=>Ht(A*S)).join(" × ")} mm`),a.voxels.show(`${R.join(" × ")} of ${Ht(S)} mm`);let{mask:C}=v.configuration;a.flow.show(C?`${Cn(C.flow_share,1)} of the volume`:"all of it"),a.flow.element.title=[W0,...(C?.files??[]).map(({file:A,sha256:P})=>`${A}, SHA-256 ${P}`)].join(`
`),c.hidden=!i.mask,l.forEach(A=>A.mask(i.mask));let M=v.model_choice?.scene;a.particles.element.hidden=a.perWindow.element.hidden=!M;let _=R.reduce((A,P)=>A*P*S,1);a.particles.show(M?`${le(Math.round(M.particles_per_mm3*_))}, ${Ht(M.particles_per_mm3,2)} per mm³`:"–"),a.perWindow.show(Ht(M?.particles_per_window,2));let b=v.model_fit;a.unexplained.show(b?b.cameras.map(A=>Cn(A.unexplained)).join(", "):"–"),a.agreement.show(Ht(b?.camera_agreement,2)),a.disparity.show(b?.camera_disparity_mm?`${Ht(b.camera_disparity_mm,2)} mm`:"–"),`${t.held??i.latestResult} ${t.frame}`!==d&&t.held===null&&performance.now()-p>CT&&y()}return{element:h,update:g,show(){y(),l.forEach(v=>v.draw())}}}function IT(i,[t,e]){let n="xyz"[3-t-e],s=q("canvas",{class:"projection",role:"img","aria-label":`Largest light along ${n}`}),r=null,o=null,a=null,c=null,l=null;new ResizeObserver(()=>h()).observe(s);function h(){let{width:d,height:u,ratio:f}=Os(s),p=s.getContext("2d");if(p.setTransform(1,0,0,1,0,0),p.clearRect(0,0,d,u),!o)return;let y=[t,e].map(A=>o.voxels_xyz[A]*o.voxel_mm),m=[t,e].map(A=>o.centre_mm[A]),[g,v,R]=[46*f,38*f,10*f],S=Math.min((d-g-R)/y[0],(u-v-R)/y[1]),[C,M]=y.map(A=>A*S),[_,b]=[g+(d-g-R-C)/2,R+(u-v-R-M)/2];if(p.imageSmoothingEnabled=!1,p.fillStyle="#000000",p.fillRect(_,b,C,M),r&&p.drawImage(r,_,b,C,M),a&&(c??=LT(a,t,e),p.drawImage(c,_,b,C,M)),l){let A=(P,D)=>[_+(P-m[0]+y[0]/2)*S,b+M-(D-m[1]+y[1]/2)*S];p.save(),p.beginPath(),p.rect(_,b,C,M),p.clip(),H0(p,l,[t,e],A,f),p.restore()}let F=Bn("ink");p.strokeStyle=p.fillStyle=F,p.lineWidth=f,p.strokeRect(_,b,C,M),p.font=`${12*f}px system-ui, sans-serif`;for(let[A,P]of[[0,"x"],[1,"y"]])for(let D of DT(m[A]-y[A]/2,m[A]+y[A]/2)){let O=(D-m[A]+y[A]/2)*S;p.beginPath(),P==="x"?(p.moveTo(_+O,b+M),p.lineTo(_+O,b+M+5*f),p.textAlign="center",p.textBaseline="top",p.fillText(Rn(D),_+O,b+M+7*f)):(p.moveTo(_,b+M-O),p.lineTo(_-5*f,b+M-O),p.textAlign="right",p.textBaseline="middle",p.fillText(Rn(D),_-8*f,b+M-O)),p.stroke()}}return{name:i,element:Be(`Along ${n}: ${"xyz"[t]} to the right, ${"xyz"[e]} upwards, in mm`,s),show(d,u,f){r?.close(),r=d,o=u,a!==f&&([a,c]=[f,null]),h()},particles(d){l=d,h()},mask(d){a!==d&&([a,c]=[d,null],h())},draw:h}}function LT(i,t,e){let[n,s]=[i.n[t],i.n[e]],r=Rf(i,t,e),o=new ImageData(n,s),a=Bn("mask"),c=[1,3,5].map(h=>parseInt(a.slice(h,h+2),16));for(let h=0;h<s;h+=1)for(let d=0;d<n;d+=1){let u=r[(s-1-h)*n+d];o.data.set([...c,Math.round(255*PT*u)],4*(h*n+d))}let l=document.createElement("canvas");return[l.width,l.height]=[n,s],l.getContext("2d").putImageData(o,0,0),l}function DT(i,t){let e=(t-i)/5,n=10**Math.floor(Math.log10(e)),s=[1,2,5,10].map(o=>o*n).find(o=>o>=e),r=[];for(let o=Math.ceil(i/s);o*s<=t+1e-9;o+=1)r.push(o*s);return r}var Dn=new Qa,Uo=new ja(Dn),Z0=new il(Dn),q0=new el(Dn),J0=Bf(Dn,Uo),Ch={overview:["Overview",()=>bm(Dn)],cameras:["Cameras",()=>_m(Dn)],volume:["Volume",()=>X0(Dn)],velocity:["Velocity",()=>z0(Dn,Z0,q0)],statistics:["Statistics",()=>Pm(Dn,q0)],run:["Run",()=>Tm(Dn,Uo)]},Ar={},Gi=null,Y0=!0,K0=Object.entries(Ch).map(([i,[t]])=>q("a",{href:`#${i}`,"data-view":i},t)),j0=q("main",{tabindex:"-1"});document.body.replaceChildren(q("header",{},J0.element,q("nav",{"aria-label":"Views"},...K0,kf()),Uo.said),j0,Uo.dialog);function Q0(){let i=location.hash.slice(1);Gi=Object.hasOwn(Ch,i)?i:"overview",Ar[Gi]??=Ch[Gi][1]();let{element:t}=Ar[Gi];t.isConnected||j0.append(t);for(let[e,n]of Object.entries(Ar))n.element.hidden=e!==Gi;K0.forEach(e=>An(e,"aria-current",e.dataset.view===Gi?"page":null)),document.title=`lfpiv bench: ${Ch[Gi][0]}`,Ar[Gi].update(),Ar[Gi].show()}function t_(){An(document.documentElement,"data-stale",Dn.stale?"":null),Dn.stale&&!Y0&&Uo.doubt(),Y0=Dn.stale,J0.update(),Ar[Gi]?.update()}window.addEventListener("hashchange",Q0);document.addEventListener("themechange",()=>Ar[Gi].show());document.addEventListener("visibilitychange",()=>{document.hidden||(Dn.ask(),Z0.fetchWanted())});Dn.watch(()=>{t_(),Dn.refusal?.status===401&&NT()});Q0();t_();Dn.start();var $0=!1;function NT(){$0||($0=!0,Uo.askForToken(Dn.refusal.message))}
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
