var Xa="";function gf(i){Xa=i.trim()}function _f(){return Xa!==""}var mn=class extends Error{constructor(t,e,n=[]){super(e),this.status=t,this.reasons=n}};function Fh(i={}){return Xa?{...i,Authorization:`Bearer ${Xa}`}:i}async function xf(i){if(i.ok)return i;let t={};try{t=await i.json()}catch{}throw new mn(i.status,t.error??`${i.status} ${i.statusText}`,t.reasons??[])}async function ko(i,{signal:t,more:e}={}){return xf(await fetch(i,{headers:Fh(e),signal:t,cache:"no-store",credentials:"omit"}))}async function os(i,t){return(await ko(i,t)).json()}async function ir(i,t){return(await ko(i,t)).arrayBuffer()}async function qa(i,t){let e=await ko(i,t),n=Number(e.headers.get("lfpiv-white"));return{bitmap:await createImageBitmap(await e.blob()),white:n}}async function vf(i,t){let e={method:"POST",headers:Fh(),credentials:"omit"};return t!==void 0&&(e.headers=Fh({"Content-Type":"application/json"}),e.body=JSON.stringify(t)),(await xf(await fetch(`/api/v1/control/${i}`,e))).json()}function Y(i,t={},...e){let n=document.createElement(i);for(let[s,r]of Object.entries(t))r===!1||r===null||r===void 0||(s.startsWith("on")?n.addEventListener(s.slice(2),r):n.setAttribute(s,r===!0?"":String(r)));return n.append(...e.flat().filter(s=>s!=null)),n}function $t(i,t){let e=String(t);i.textContent!==e&&(i.textContent=e)}function Un(i,t,e){e===null?i.removeAttribute(t):i.getAttribute(t)!==String(e)&&i.setAttribute(t,e)}function Wt(i,{wide:t=!1,title:e}={}){let n=Y("dd",{class:"value"},"–");return{element:Y("div",{class:t?"reading wide":"reading",title:e},Y("dt",{},i),n),show(r,o=null){$t(n,r),Un(n,"data-tone",o)}}}function en(i,...t){return Y("section",{class:"panel"},Y("h2",{},i),...t)}var Oh=0;function as(i,t,e){let n=`choice-${Oh+=1}`,s=Y("select",{id:n,onchange:()=>e(s.value)},...Object.entries(t).map(([r,o])=>Y("option",{value:r},o)));return{element:Y("div",{class:"choice"},Y("label",{for:n},i),s),input:s}}function zo(i,{max:t,value:e=0,step:n=1},s){let r=`slider-${Oh+=1}`,o=Y("output",{for:r}),a=Y("input",{id:r,type:"range",min:0,max:t,step:n,value:e,oninput:()=>s(Number(a.value))});return{element:Y("div",{class:"choice"},Y("label",{for:r},i),a,o),input:a,shown:o}}function Ns(i,t,e){let n=`tick-${Oh+=1}`,s=Y("input",{id:n,type:"checkbox",checked:t,onchange:()=>e(s.checked)});return{element:Y("div",{class:"choice tick"},s,Y("label",{for:n},i)),input:s}}function Us(i){let t=Math.min(window.devicePixelRatio||1,2),e=Math.max(1,Math.round(i.clientWidth*t)),n=Math.max(1,Math.round(i.clientHeight*t));return(i.width!==e||i.height!==n)&&(i.width=e,i.height=n),{width:e,height:n,ratio:t}}function Fn(i){return getComputedStyle(document.documentElement).getPropertyValue(`--${i}`).trim()}var e_=15e3,Ya=class{constructor(t){this.run=t,this.said=Y("p",{class:"said",role:"status"}),this.input=Y("input",{type:"password",id:"token",autocomplete:"off",spellcheck:"false",size:40}),this.why=Y("p",{}),this.dialog=Y("dialog",{"aria-labelledby":"token-title"},Y("form",{onsubmit:e=>this.take(e)},Y("h2",{id:"token-title"},"Token"),this.why,Y("label",{for:"token"},"Token of scope read or control"),this.input,Y("p",{class:"hint"},"It is kept in this page's memory until the page is closed, and nowhere else."),Y("div",{class:"row"},Y("button",{type:"submit",class:"primary"},"Use it"),Y("button",{type:"button",onclick:()=>this.dialog.close()},"Cancel"))))}askForToken(t=""){$t(this.why,t),this.dialog.open||this.dialog.showModal(),this.input.focus()}take(t){t.preventDefault(),gf(this.input.value),this.input.value="",this.dialog.close(),this.run.reconnect(),this.say(_f()?"The token is used from now on.":"No token is used.")}say(t,e=null){$t(this.said,t),e?this.said.setAttribute("data-tone",e):this.said.removeAttribute("data-tone"),clearTimeout(this.fading),t&&!e&&(this.fading=setTimeout(()=>this.say(""),e_))}doubt(){this.said.hasAttribute("data-tone")||this.say("")}async send(t,e){this.say(`${t} …`);try{let n=await vf(t,e);return this.say(n.pending?`${t}: the bench is still about it.`:`${t}: done, the run is ${n.mode}.`),!0}catch(n){let s=n instanceof mn?n.message:"the daemon does not answer: use the interlock";return this.say(`${t} failed: ${s}`,"bad"),n instanceof mn&&n.status===401&&this.askForToken(`${t} needs a token of scope control.`),!1}finally{this.run.ask()}}};var Bh=class{constructor({event:t,comment:e}){this.event=t,this.comment=e,this.rest="",this.clear()}clear(){this.name="message",this.id=null,this.data=[]}push(t){let e=(this.rest+t).split(`
`);this.rest=e.pop(),e.forEach(n=>this.line(n.replace(/\r$/,"")))}line(t){if(t===""){this.data.length>0&&this.event(this.name,this.data.join(`
`),this.id),this.clear();return}if(t.startsWith(":")){this.comment(t.slice(1).trim());return}let e=t.indexOf(":"),n=e<0?t:t.slice(0,e),s=e<0?"":t.slice(e+1).replace(/^ /,"");n==="event"?this.name=s:n==="id"?this.id=s:n==="data"&&this.data.push(s)}};async function yf(i,t,e){let s=await ko("/api/v1/events",{signal:e,more:i?{Accept:"text/event-stream","Last-Event-ID":i}:{Accept:"text/event-stream"}}),r=new Bh(t),o=new TextDecoder,a=s.body.getReader();for(;;){let{done:c,value:l}=await a.read();if(c)return;r.push(o.decode(l,{stream:!0}))}}var n_="LFPIVMK1";async function Sf(){return i_(await ir("/api/v1/mask"))}function i_(i){let t=new DataView(i),e=String.fromCharCode(...new Uint8Array(i,0,8));if(e!==n_)throw new Error(`a mask of another version: ${e}`);let n=[16,20,24].map(o=>t.getUint32(o,!0)),s=new Uint8Array(i,t.getUint32(28,!0)),r=new Uint8Array(n[0]*n[1]*n[2]);for(let o=0;o<r.length;o+=1)r[o]=s[o>>3]>>(o&7)&1;return{n,first:[32,40,48].map(o=>t.getFloat64(o,!0)),voxel:t.getFloat64(56,!0),flow:r}}function Mf(i,t,e){let{n,flow:s}=i,r=[1,n[0],n[0]*n[1]],o=3-t-e,a=new Float32Array(n[t]*n[e]);for(let c=0;c<n[e];c+=1)for(let l=0;l<n[t];l+=1){let h=c*r[e]+l*r[t],d=0;for(let u=0;u<n[o];u+=1,h+=r[o])d+=1-s[h];a[c*n[t]+l]=d/n[o]}return a}function bf(i,t,e){let{n,first:s,voxel:r,flow:o}=i,a=[1,n[0],n[0]*n[1]],c=[],l=t.map((d,u)=>Math.max(0,Math.ceil((d-s[u])/r-1e-6))),h=e.map((d,u)=>Math.min(n[u]-1,Math.floor((d-s[u])/r+1e-6)));for(let d=l[2];d<=h[2];d+=1)for(let u=l[1];u<=h[1];u+=1)for(let f=l[0];f<=h[0];f+=1){let p=[f,u,d],y=f+u*a[1]+d*a[2];for(let m=0;m<3;m+=1)p[m]<h[m]&&o[y]!==o[y+a[m]]&&c.push(...s_(i,p,m))}return new Float32Array(c)}function s_({first:i,voxel:t},e,n){let[s,r]=[(n+1)%3,(n+2)%3],o=(c,l)=>{let h=e.map((d,u)=>i[u]+d*t);return h[n]+=t/2,h[s]+=(c-.5)*t,h[r]+=(l-.5)*t,h},a=[o(0,0),o(1,0),o(1,1),o(0,1)];return[0,1,2,0,2,3].flatMap(c=>a[c])}var r_=[[1e12,"T"],[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""]];function qt(i,t=3){if(i==null||!Number.isFinite(i))return"–";if(i===0)return"0";let e=Math.max(0,Math.min(6,t-1-Math.floor(Math.log10(Math.abs(i)))));return i.toFixed(e).replace("-","−")}function On(i){return i===null?"":String(Number(i.toPrecision(6))).replace("-","−")}function Me(i){return i==null?"–":i.toLocaleString("en-GB").replaceAll(","," ")}function An(i,t=0){return i==null||!Number.isFinite(i)?"–":`${(100*i).toFixed(t)} %`}function wf(i){if(i==null)return"–";let[t,e]=r_.find(([n])=>i>=n)??[1,""];return`${qt(i/t)} ${e}B`}function ls(i){return i==null||!Number.isFinite(i)?"–":i<10?`${qt(i,2)} s`:i<120?`${Math.round(i)} s`:i<7200?`${Math.round(i/60)} min`:`${qt(i/3600)} h`}function Tf(i){let t=i?new Date(i):null;return t&&!Number.isNaN(t.getTime())?t.toLocaleTimeString("en-GB"):"–"}var o_={starting:"starting",running:"running",bench_lost:"synchroniser lost",stopping:"stopping",finished:"finished",failed:"failed"},Ef=i=>o_[i]??i??"–",a_={awaiting_frames:"waits for frames",queued:"queued",processing:"is measured",done:"done",failed:"failed",write_failed:"not written",shed:"shed",not_fired:"not fired",lost:"lost"},Vo=i=>a_[i]??i??"–",l_={complete:"complete",missing_packets:"packets missing",underrun:"no buffer",missed_trigger:"missed trigger",late:"late",unpaired:"unpaired",shed:"shed",write_failed:"not written",not_fired:"not fired"},kh=i=>l_[i]??i??"open",c_={start:"start",stop:"stop",arm:"arm",disarm:"disarm",go_on:"go on",set_dt:"dt",note:"note"};function Af(i){let t=c_[i.command]??String(i.command);return i.refused?{tone:"bad",text:`${t} was refused: ${i.refused.join("; ")}`}:i.command==="note"?{tone:"note",text:`Note: ${i.text}`}:i.command==="set_dt"?{tone:null,text:`dt is ${qt(i.dt_us)} µs from the next burst on`}:{tone:null,text:`${t}: the run is ${i.mode}`}}function Rf(i){let t=`Shot ${i.shot}`;return i.stage==="failed"?{tone:"bad",text:`${t} gave no result: ${i.message??"no reason given"}`}:i.stage==="write_failed"?{tone:"bad",text:`${t} was not written: ${i.message??""}`}:i.fit&&i.fit.verdict!=="good"?{tone:i.fit.verdict==="poor"?"bad":"doubt",text:`${t}: model fit ${i.fit.verdict}. ${i.fit.causes[0]??""}`}:i.warnings?.length?{tone:"doubt",text:`${t}: ${i.warnings[0]}`}:null}var h_=2e3,zh=200,u_=200,d_=400,f_=900,p_=2e3,m_=200,Cf=[300,600,1200,2500],$a=class{constructor(){this.listeners=new Set,this.resultListeners=new Set,this.forget(),this.connection="connecting",this.refusal=null,this.lastSign=-1/0,this.aborter=null,this.attempt=0,this.toldStale=null,this.telling=null}forget(){this.run=null,this.lastId=null,this.historyUpTo=0,this.status=null,this.brief=null,this.control=null,this.shots=new Map,this.log=[],this.latestResult=null,this.finished=[],this.frames=[],this.backlog=[],this.mask=null}get stale(){return performance.now()-this.lastSign>h_}watch(t){this.listeners.add(t)}watchResults(t){this.resultListeners.add(t)}tell(){this.telling??=setTimeout(()=>{this.telling=null,this.toldStale=this.stale,this.listeners.forEach(t=>t())},m_)}start(){this.connect(),setInterval(()=>this.ask(),p_),setInterval(()=>{this.stale!==this.toldStale&&this.tell()},250)}reconnect(){this.attempt=0,this.aborter?.abort(),this.waiting&&(clearTimeout(this.waiting),this.connect())}async connect(){this.waiting=null,this.aborter=new AbortController;let t={event:(n,s,r)=>this.event(n,s,r),comment:n=>n==="heartbeat"&&this.sign()};try{this.ask(),await yf(this.lastId,t,this.aborter.signal),this.connection="lost"}catch(n){this.refusal=n instanceof mn?n:null,this.connection=this.refusal?"refused":"lost"}this.tell();let e=this.aborter.signal.aborted?0:Cf[Math.min(this.attempt,Cf.length-1)];this.attempt+=1,this.waiting=setTimeout(()=>this.connect(),e)}sign(){this.lastSign=performance.now(),this.attempt=0,this.refusal=null,this.connection="live",this.toldStale&&this.tell()}event(t,e,n){let s=JSON.parse(e),r=n?this.place(n):null,o=r!==null&&r<=this.historyUpTo;t==="status"&&!o?(this.brief=s,this.control=s.control,this.noteFrames(s.cameras),this.sign()):t==="control"?(!o&&s.mode&&(this.control={mode:s.mode,dt_us:s.dt_us,held:s.held}),this.note(Af(s),o),o||this.ask()):t==="shot"?this.shotEnded(s,o):t==="result"&&!o?(this.latestResult=s.shot,this.resultListeners.forEach(a=>a(s.shot))):t==="watermarks"&&this.brief?this.brief.watermarks=s:t==="missed"&&s.missed&&this.note({tone:"doubt",text:`${s.missed} events were missed`},o),this.tell()}place(t){let[e,n]=t.split("-"),s=Number(n);if(e!==this.run){let r=this.run!==null;this.forget(),r&&(this.note({tone:null,text:"The daemon was started again: this is another run"},!1),this.resultListeners.forEach(o=>o(null))),this.run=e,this.historyUpTo=s,this.lastId=`${e}-${Math.max(0,s-d_)}`,s>0&&queueMicrotask(()=>this.aborter?.abort()),this.ask()}else this.lastId=t;return s}noteFrames(t){let e=performance.now();this.frames=(t??[]).map(({camera:n,connected:s,frames:r},o)=>{let a=this.frames[o],c=a&&a.frames===r?a.since:e;return{camera:n,connected:s,frames:r,since:c}})}noteBacklog(t){t&&(this.backlog.push({at:performance.now(),backlog:t.shots.backlog,inHand:t.shots.in_hand}),this.backlog.length>f_&&this.backlog.shift())}shotEnded(t,e){let{shot:n}=t,s=this.shots.get(n)??{shot:n,cameras:[]};this.keepShot({...s,...t,state:t.stage,model_fit:t.fit}),e||(this.finished.push({at:performance.now(),shot:n}),this.finished.length>zh&&this.finished.shift());let r=Rf(t);r&&this.note(r,e)}keepShot(t){for(this.shots.set(t.shot,t);this.shots.size>zh;)this.shots.delete(Math.min(...this.shots.keys()))}note(t,e){this.log.push({...t,at:e?null:new Date}),this.log.length>u_&&this.log.shift()}async ask(){if(this.asking||document.hidden)return;this.asking=!0;let{signal:t}=this.aborter??new AbortController;try{let[e,n,s]=await Promise.all([os("/api/v1/status",{signal:t}),os("/api/v1/control",{signal:t}),os("/api/v1/shots?limit=60",{signal:t})]);if(this.status=e,this.noteBacklog(e.cluster),this.permissions=n,this.control=n.state,this.brief||this.noteFrames(e.cameras),s.shots.reverse().forEach(r=>this.keepShot(r)),this.latestResult===null){let o=[...this.shots.values()].filter(a=>a.vectors).map(a=>a.shot).sort((a,c)=>c-a)[0];o!==void 0&&(this.latestResult=o,this.resultListeners.forEach(a=>a(o)))}e.configuration.mask&&!this.mask&&(this.mask=await Sf()),this.refusal=null}catch(e){e instanceof mn&&(this.refusal=e)}finally{this.asking=!1,this.tell()}}latestShots(t){return[...this.shots.values()].sort((e,n)=>n.shot-e.shot).slice(0,t)}get lastEnded(){return this.latestShots(zh).find(t=>["done","failed","write_failed","lost"].includes(t.state))}get rate(){let t=performance.now(),e=this.finished.filter(({at:n})=>t-n<1e4);return e.length<2?0:e.length/Math.max(1,(t-e[0].at)/1e3)}};var g_=3e3;function Za(i){if(i.stale)return{word:"unknown",detail:"no sign of life: use the interlock",tone:"unknown"};let t=i.brief?.state??i.status?.state;if(i.permissions&&!i.permissions.controllable)return{word:"no laser",detail:"a recorded run is shown",tone:"safe"};if(t==="failed")return{word:"unknown",detail:"the run has failed: use the interlock",tone:"unknown"};if(t==="finished")return{word:"safe",detail:"the run is over",tone:"safe"};let e=i.control;if(!e||t==="starting")return{word:"safe",detail:t==="starting"?"disabled while the run starts":"nothing is fired",tone:"safe"};switch(e.mode){case"disarmed":return{word:"safe",detail:"disarmed: lamps and Q-switches off",tone:"safe"};case"armed":return{word:"armed",detail:"the lamps fire, the Q-switches do not",tone:"armed"};case"firing":return e.held?.length?{word:"held",detail:e.held.join("; "),tone:"armed"}:{word:"firing",detail:"light pulses: goggles on",tone:"firing"};case"lost":return{word:"unknown",detail:"the synchroniser does not answer: use the interlock",tone:"unknown"};case"stopping":return{word:"stopping",detail:"the laser is made safe",tone:"armed"};default:return{word:"unknown",detail:`mode ${e.mode}`,tone:"unknown"}}}function Pf(i){return(i.status?.configuration.cameras??i.frames.map(e=>e.camera)).map((e,n)=>{let s=i.frames[n];if(i.stale||!s)return{name:e,word:"unknown",tone:"unknown"};if(i.permissions&&!i.permissions.controllable)return{name:e,word:"recorded",tone:"safe"};if(!s.connected)return{name:e,word:"gone",tone:"bad"};let r=i.control?.mode==="firing"&&!i.control.held?.length,o=performance.now()-s.since;return r&&o>g_?{name:e,word:"silent",tone:"doubt"}:{name:e,word:r?"delivers":"alive",tone:"good"}})}function If(i){let t=i.lastEnded;if(!t)return{word:"none yet",detail:"",tone:null};let e=`shot ${t.shot}`;if(t.state!=="done")return{word:Vo(t.state),detail:e,tone:i.stale?"unknown":"bad"};let n=t.model_fit?.verdict,s=`${e}, ${An(t.valid_share)} valid`;return i.stale?{word:n??"measured",detail:s,tone:"unknown"}:{word:n??"measured",detail:s,tone:{good:"good",doubtful:"doubt",poor:"bad"}[n]??null}}function Vh(i,t=""){let e=Y("strong",{}),n=Y("span",{class:"detail"}),s=Y("div",{class:`lamp ${t}`},Y("span",{class:"label"},i),e,n);return{element:s,show({word:r,detail:o="",tone:a}){$t(e,r),$t(n,o),Un(s,"data-tone",a??null),Un(s,"title",o||null)}}}function Lf(i,t){let e=Vh("Laser","laser"),n=Y("div",{class:"cameras"}),s=Vh("Last shot","shot"),r=Y("span",{class:"live",role:"status"}),o=Y("button",{type:"button",class:"stop",onclick:()=>t.send("stop")},"Stop"),a=Y("button",{type:"button",class:"disarm",onclick:()=>t.send("disarm")},"Disarm"),c=Y("button",{type:"button",class:"quiet",onclick:()=>t.askForToken()},"Token"),l=Y("div",{class:"safety"},Y("div",{class:"press"},o,a),e.element,n,s.element,Y("div",{class:"connection"},r,c)),h=[];function d(){e.show(Za(i));let u=Pf(i);for(;h.length<u.length;)h.push(Vh("","camera")),n.append(h.at(-1).element);h.forEach((p,y)=>{let m=u[y];p.element.hidden=!m,m&&($t(p.element.firstChild,m.name),p.show(m))}),s.show(If(i));let f=i.permissions&&!i.permissions.controllable;o.disabled=a.disabled=!!f,$t(r,i.stale?__(i):f?"recorded":"live"),Un(r,"data-tone",i.stale?"bad":"good")}return{element:l,update:d}}function __(i){return i.refusal?i.refusal.message:i.connection==="connecting"?"connecting":"no sign of life"}var x_={auto:"light",light:"dark",dark:"auto"};function Df(){let i="auto",t=Y("button",{type:"button",class:"quiet theme",onclick:()=>e(x_[i])},"Theme: auto");function e(n){i=n,$t(t,`Theme: ${n}`),n==="auto"?document.documentElement.removeAttribute("data-theme"):document.documentElement.setAttribute("data-theme",n),document.dispatchEvent(new Event("themechange"))}return t}var v_="LFPIVVF2";function Gh(i){let t=new DataView(i),e=String.fromCharCode(...new Uint8Array(i,0,8));if(e!==v_)throw new Error(`a field of another version: ${e}`);let n=[16,20,24].map(y=>t.getUint32(y,!0)),s=n[0]*n[1]*n[2],r=t.getUint32(28,!0),[o,a,c,l]=[[32,40,48].map(y=>t.getFloat64(y,!0)),t.getFloat64(56,!0),t.getFloat64(64,!0),t.getFloat64(72,!0)],h=new Float32Array(i,r,3*s),d=new Uint8Array(i,r+16*s,s),u=Math.ceil((r+17*s)/4)*4,f=c*.001/l,p=y=>y.map(m=>m*f);return{shot:Number(t.getBigUint64(8,!0)),n,first:o,spacing:a,voxel:c,dt:l,displacement:h,status:d,u:p(h),uncertainty:p(new Float32Array(i,u,3*s))}}function Nf(i,t){return!!(i&&t)&&i.spacing===t.spacing&&i.n.every((e,n)=>e===t.n[n]&&i.first[n]===t.first[n])}var Ja=(i,t,e,n)=>t+i.n[0]*(e+i.n[1]*n);function Fr(i){let t=new Float32Array(i.length/3);for(let e=0;e<t.length;e+=1)t[e]=Math.hypot(i[3*e],i[3*e+1],i[3*e+2]);return t}function Hh(i,t){let e=new Float32Array(i.length/3);for(let n=0;n<e.length;n+=1)e[n]=i[3*n+t];return e}function Uf(i,t=i.u){let{n:e,spacing:n}=i,s=[1,e[0],e[0]*e[1]],r=new Float32Array(t.length);for(let o=0;o<e[2];o+=1)for(let a=0;a<e[1];a+=1)for(let c=0;c<e[0];c+=1){let l=Ja(i,c,a,o),h=[c,a,o],d=(u,f)=>{let p=A=>h[f]+A>=0&&h[f]+A<e[f]?t[3*(l+A*s[f])+u]:NaN,[y,m,g]=[p(-1),p(0),p(1)];if(m!==m)return NaN;let v=n*.001;return y===y&&g===g?(g-y)/(2*v):g===g?(g-m)/v:(m-y)/v};r[3*l]=d(2,1)-d(1,2),r[3*l+1]=d(0,2)-d(2,0),r[3*l+2]=d(1,0)-d(0,1)}return r}function qi(i,t){let e=Float32Array.from(i).filter(n=>n===n).sort();return e.length?e[Math.min(e.length-1,Math.floor(t*e.length))]:NaN}function Wh(i){return i.status.reduce((t,e)=>t+(e!==3),0)}function Ff(i){let t=0;for(let e of i.status)t+=e===0;return t/Math.max(1,Wh(i))}var Ka=class{constructor(){this.clear()}clear(){this.grid=null,this.shots=0}add(t){(!Nf(this.grid,t)||this.grid.dt!==t.dt)&&(this.grid=t,this.shots=0,this.counts=new Uint32Array(t.status.length),this.means=new Float64Array(t.u.length),this.squares=new Float64Array(t.u.length)),this.shots+=1;for(let e=0;e<t.status.length;e+=1){if(t.status[e]!==0)continue;let n=this.counts[e]+=1;for(let s=3*e;s<3*e+3;s+=1){let r=t.u[s]-this.means[s];this.means[s]+=r/n,this.squares[s]+=r*(t.u[s]-this.means[s])}}}mean(){return Float32Array.from(this.means,(t,e)=>this.counts[Math.floor(e/3)]>0?t:NaN)}rms(){return Float32Array.from(this.squares,(t,e)=>{let n=this.counts[Math.floor(e/3)];return n>1?Math.sqrt(t/(n-1)):NaN})}};var y_=250,ja=class{constructor(t){this.run=t,this.running=new Ka,this.field=null,this.held=null,this.error=null,this.listeners=new Set,this.wanted=null,this.busy=!1,this.lastFetch=-1/0,t.watchResults(e=>this.isReady(e))}watch(t){this.listeners.add(t)}tell(){this.listeners.forEach(t=>t())}isReady(t){if(t===null){this.running.clear(),this.field=this.held=this.wanted=null,this.tell();return}this.wanted=t,this.fetchWanted()}hold(t){this.held=t,t===null?(this.wanted=this.run.latestResult,this.fetchWanted()):this.fetchHeld(t),this.tell()}async fetchWanted(){if(this.busy||this.wanted===null||document.hidden)return;let t=y_-(performance.now()-this.lastFetch);if(t>0){this.timer??=setTimeout(()=>{this.timer=null,this.fetchWanted()},t);return}let e=this.wanted;this.wanted=null,this.busy=!0,this.lastFetch=performance.now();try{let n=Gh(await ir(`/api/v1/results/${e}?format=binary`));this.running.add(n),this.held===null&&(this.field=n),this.error=null,this.tell()}catch(n){this.fail(n)}finally{this.busy=!1,this.fetchWanted()}}async fetchHeld(t){try{let e=Gh(await ir(`/api/v1/results/${t}?format=binary`));this.held===t&&(this.field=e),this.error=null}catch(e){this.fail(e)}this.tell()}fail(t){this.error=t instanceof mn?t.message:"the daemon does not answer",this.tell()}};var S_="uplot",M_="u-hz",b_="u-vt",w_="u-title",T_="u-wrap",E_="u-under",A_="u-over",R_="u-axis",or="u-off",C_="u-select",P_="u-cursor-x",I_="u-cursor-y",L_="u-cursor-pt",D_="u-legend",N_="u-live",U_="u-inline",F_="u-series",O_="u-marker",Of="u-label",B_="u-value",Ho="width",Wo="height";var Bf="bottom",Or="left",qh="right",cu="#000",kf=cu+"0",Yh="mousemove",zf="mousedown",$h="mouseup",Vf="mouseenter",Gf="mouseleave",Hf="dblclick",k_="resize",z_="scroll",Wf="change",il="dppxchange",hu="--",Wr=typeof window<"u",Qh=Wr?document:null,kr=Wr?window:null,V_=Wr?navigator:null,Ee,Qa;function tu(){let i=devicePixelRatio;Ee!=i&&(Ee=i,Qa&&nu(Wf,Qa,tu),Qa=matchMedia(`(min-resolution: ${Ee-.001}dppx) and (max-resolution: ${Ee+.001}dppx)`),ar(Wf,Qa,tu),kr.dispatchEvent(new CustomEvent(il)))}function ci(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function eu(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Xe(i,t,e){i.style[t]=e+"px"}function Ri(i,t,e,n){let s=Qh.createElement(i);return t!=null&&ci(s,t),e?.insertBefore(s,n),s}function yi(i,t){return Ri("div",i,t)}var Xf=new WeakMap;function Yi(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=Xf.get(i);r!=o&&(i.style.transform=r,Xf.set(i,r),t<0||e<0||t>n||e>s?ci(i,or):eu(i,or))}var qf=new WeakMap;function Yf(i,t,e){let n=t+e,s=qf.get(i);n!=s&&(qf.set(i,n),i.style.background=t,i.style.borderColor=e)}var $f=new WeakMap;function Zf(i,t,e,n){let s=t+""+e,r=$f.get(i);s!=r&&($f.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var uu={passive:!0},G_={...uu,capture:!0};function ar(i,t,e,n){t.addEventListener(i,e,n?G_:uu)}function nu(i,t,e,n){t.removeEventListener(i,e,uu)}Wr&&tu();function Ci(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:hi((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function bp(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var wp=i=>i!=null,Tp=i=>i!=null&&i>0,ol=bp(wp),H_=bp(Tp);function W_(i,t,e,n=0,s=!1){let r=s?H_:ol,o=s?Tp:wp;[t,e]=r(i,t,e);let a=i[t],c=i[t];if(t>-1)if(n==1)a=i[t],c=i[e];else if(n==-1)a=i[e],c=i[t];else for(let l=t;l<=e;l++){let h=i[l];o(h)&&(h<a?a=h:h>c&&(c=h))}return[a??ke,c??-ke]}function al(i,t,e,n){let s=jf(i),r=jf(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?cs:Ep,a=s==1?hi:Si,c=r==1?Si:hi,l=a(o(_n(i))),h=c(o(_n(t))),d=zr(e,l),u=zr(e,h);return e==10&&(l<0&&(d=ze(d,-l)),h<0&&(u=ze(u,-h))),n||e==2?(i=d*s,t=u*r):(i=Pp(i,d),t=ll(t,u)),[i,t]}function du(i,t,e,n){let s=al(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var fu=.1,Jf={mode:3,pad:fu},qo={pad:0,soft:null,mode:0},X_={min:qo,max:qo};function sl(i,t,e,n){return cl(e)?Kf(i,t,e):(qo.pad=e,qo.soft=n?0:null,qo.mode=n?3:0,Kf(i,t,X_))}function we(i,t){return i??t}function q_(i,t,e){for(t=we(t,0),e=we(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function Kf(i,t,e){let n=e.min,s=e.max,r=we(n.pad,0),o=we(s.pad,0),a=we(n.hard,-ke),c=we(s.hard,ke),l=we(n.soft,ke),h=we(s.soft,-ke),d=we(n.mode,0),u=we(s.mode,0),f=t-i,p=cs(f),y=Kn(_n(i),_n(t)),m=cs(y),g=_n(m-p);(f<1e-24||g>10)&&(f=0,(i==0||t==0)&&(f=1e-24,d==2&&l!=ke&&(r=0),u==2&&h!=-ke&&(o=0)));let v=f||y||1e3,A=cs(v),S=zr(10,hi(A)),C=v*(f==0?i==0?.1:1:r),M=ze(Pp(i-C,S/10),24),_=i>=l&&(d==1||d==3&&M<=l||d==2&&M>=l)?l:ke,b=Kn(a,M<_&&i>=_?_:Pi(_,M)),N=v*(f==0?t==0?.1:1:o),R=ze(ll(t+N,S/10),24),P=t<=h&&(u==1||u==3&&R>=h||u==2&&R<=h)?h:-ke,O=Pi(c,R>P&&t<=P?P:Kn(P,R));return b==O&&b==0&&(O=100),[b,O]}var Y_=new Intl.NumberFormat(Wr?V_.language:"en-US"),pu=i=>Y_.format(i),ui=Math,nl=ui.PI,_n=ui.abs,hi=ui.floor,gn=ui.round,Si=ui.ceil,Pi=ui.min,Kn=ui.max,zr=ui.pow,jf=ui.sign,cs=ui.log10,Ep=ui.log2,$_=(i,t=1)=>ui.sinh(i)*t,Zh=(i,t=1)=>ui.asinh(i/t),ke=1/0;function Qf(i){return(cs((i^i>>31)-(i>>31))|0)+1}function iu(i,t,e){return Pi(Kn(i,t),e)}function Ap(i){return typeof i=="function"}function ve(i){return Ap(i)?i:()=>i}var Z_=()=>{},Rp=i=>i,Cp=(i,t)=>t,J_=i=>null,tp=i=>!0,ep=(i,t)=>i==t,K_=/\.\d*?(?=9{6,}|0{6,})/gm,lr=i=>{if(Lp(i)||Os.has(i))return i;let t=`${i}`,e=t.match(K_);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${lr(s)}e${r}`}return ze(i,n)};function sr(i,t){return lr(ze(lr(i/t))*t)}function ll(i,t){return lr(Si(lr(i/t))*t)}function Pp(i,t){return lr(hi(lr(i/t))*t)}function ze(i,t=0){if(Lp(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return gn(n)/e}var Os=new Map;function Ip(i){return((""+i).split(".")[1]||"").length}function $o(i,t,e,n){let s=[],r=n.map(Ip);for(let o=t;o<e;o++){let a=_n(o),c=ze(zr(i,o),a);for(let l=0;l<n.length;l++){let h=i==10?+`${n[l]}e${o}`:n[l]*c,d=(o>=0?0:a)+(o>=r[l]?0:r[l]),u=i==10?h:ze(h,d);s.push(u),Os.set(u,d)}}return s}var Yo={},mu=[],Vr=[null,null],Fs=Array.isArray,Lp=Number.isInteger,j_=i=>i===void 0;function np(i){return typeof i=="string"}function cl(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function Q_(i){return i!=null&&typeof i=="object"}var tx=Object.getPrototypeOf(Uint8Array),Dp="__proto__";function Gr(i,t=cl){let e;if(Fs(i)){let n=i.find(s=>s!=null);if(Fs(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Gr(i[s],t)}else e=i.slice()}else if(i instanceof tx)e=i.slice();else if(t(i)){e={};for(let n in i)n!=Dp&&(e[n]=Gr(i[n],t))}else e=i;return e}function un(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=Dp&&(cl(i[s])?un(i[s],Gr(n[s])):i[s]=Gr(n[s]))}return i}var ex=0,nx=1,ix=2;function sx(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function rx(i,t){if(lx(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return cx(o[0])||(o=ax(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let c=i[o][0],l=c.length;for(let h=0;h<l;h++)e.add(c[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],c=a[0];for(let l=1;l<a.length;l++){let h=a[l],d=Array(s).fill(void 0),u=t?t[o][l]:nx,f=[];for(let p=0;p<h.length;p++){let y=h[p],m=r.get(c[p]);y===null?u!=ex&&(d[m]=y,u==ix&&f.push(m)):d[m]=y}sx(d,f,s),n.push(d)}}return n}var ox=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function ax(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let c=0;c<e;c++)a[c]=o[n[c]];s.push(a)}return s}function lx(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function cx(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Kn(1,hi((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let c=i[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var Np=["January","February","March","April","May","June","July","August","September","October","November","December"],Up=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Fp(i){return i.slice(0,3)}var hx=Up.map(Fp),ux=Np.map(Fp),dx={MMMM:Np,MMM:ux,WWWW:Up,WWW:hx};function Go(i){return(i<10?"0":"")+i}function fx(i){return(i<10?"00":i<100?"0":"")+i}var px={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Go(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Go(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Go(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Go(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Go(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>fx(i.getMilliseconds())};function gu(i,t){t=t||dx;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?px[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var mx=new Intl.DateTimeFormat().resolvedOptions().timeZone;function gx(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==mx?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var Op=i=>i%1==0,rl=[1,2,2.5,5],_x=$o(10,-32,0,rl),Bp=$o(10,0,32,rl),xx=Bp.filter(Op),rr=_x.concat(Bp),_u=`
`,kp="{YYYY}",ip=_u+kp,zp="{M}/{D}",Xo=_u+zp,tl=Xo+"/{YY}",Vp="{aa}",vx="{h}:{mm}",Br=vx+Vp,sp=_u+Br,rp=":{ss}",Ce=null;function Gp(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,c=(i==1?$o(10,0,3,rl).filter(Op):$o(10,-3,0,rl)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,kp,Ce,Ce,Ce,Ce,Ce,Ce,1],[s*28,"{MMM}",ip,Ce,Ce,Ce,Ce,Ce,1],[s,zp,ip,Ce,Ce,Ce,Ce,Ce,1],[n,"{h}"+Vp,tl,Ce,Xo,Ce,Ce,Ce,1],[e,Br,tl,Ce,Xo,Ce,Ce,Ce,1],[t,rp,tl+" "+Br,Ce,Xo+" "+Br,Ce,sp,Ce,1],[i,rp+".{fff}",tl+" "+Br,Ce,Xo+" "+Br,Ce,sp,Ce,1]];function h(d){return(u,f,p,y,m,g)=>{let v=[],A=m>=o,S=m>=r&&m<o,C=d(p),M=ze(C*i,3),_=Jh(C.getFullYear(),A?0:C.getMonth(),S||A?1:C.getDate()),b=ze(_*i,3);if(S||A){let N=S?m/r:0,R=A?m/o:0,P=M==b?M:ze(Jh(_.getFullYear()+R,_.getMonth()+N,1)*i,3),O=new Date(gn(P/i)),z=O.getFullYear(),D=O.getMonth();for(let H=0;P<=y;H++){let W=Jh(z+R*H,D+N*H,1),V=W-d(ze(W*i,3));P=ze((+W+V)*i,3),P<=y&&v.push(P)}}else{let N=m>=s?s:m,R=hi(p)-hi(M),P=b+R+ll(M-b,N);v.push(P);let O=d(P),z=O.getHours()+O.getMinutes()/e+O.getSeconds()/n,D=m/n,H=u.axes[f]._space,W=g/H;for(;P=ze(P+m,i==1?0:3),!(P>y);)if(D>1){let V=hi(ze(z+D,6))%24,k=d(P).getHours()-V;k>1&&(k=-1),P-=k*n,z=(z+D)%24;let Q=v[v.length-1];ze((P-Q)/m,3)*W>=.7&&v.push(P)}else v.push(P)}return v}}return[c,l,h]}var[yx,Sx,Mx]=Gp(1),[bx,wx,Tx]=Gp(.001);$o(2,-53,53,[1]);function op(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function ap(i,t){return(e,n,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],c,l,h,d,u,f;return n.map(p=>{let y=i(p),m=y.getFullYear(),g=y.getMonth(),v=y.getDate(),A=y.getHours(),S=y.getMinutes(),C=y.getSeconds(),M=m!=c&&a[2]||g!=l&&a[3]||v!=h&&a[4]||A!=d&&a[5]||S!=u&&a[6]||C!=f&&a[7]||a[1];return c=m,l=g,h=v,d=A,u=S,f=C,M(y)})}}function Ex(i,t){let e=gu(t);return(n,s,r,o,a)=>s.map(c=>e(i(c)))}function Jh(i,t,e){return new Date(i,t,e)}function lp(i,t){return t(i)}var Ax="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function cp(i,t){return(e,n,s,r)=>r==null?hu:t(i(n))}function Rx(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function Cx(i,t){return i.series[t].fill(i,t)}var Px={show:!0,live:!0,isolate:!1,mount:Z_,markers:{show:!0,width:2,stroke:Rx,fill:Cx,dash:"solid"},idx:null,idxs:null,values:[]};function Ix(i,t){let e=i.cursor.points,n=yi(),s=e.size(i,t);Xe(n,Ho,s),Xe(n,Wo,s);let r=s/-2;Xe(n,"marginLeft",r),Xe(n,"marginTop",r);let o=e.width(i,t,s);return o&&Xe(n,"borderWidth",o),n}function Lx(i,t){let e=i.series[t].points;return e._fill||e._stroke}function Dx(i,t){let e=i.series[t].points;return e._stroke||e._fill}function Nx(i,t){return i.series[t].points.size}var Kh=[0,0];function Ux(i,t,e){return Kh[0]=t,Kh[1]=e,Kh}function el(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function jh(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var Fx={show:!0,x:!0,y:!0,lock:!1,move:Ux,points:{one:!1,show:Ix,size:Nx,width:0,stroke:Dx,fill:Lx},bind:{mousedown:el,mouseup:el,click:el,dblclick:el,mousemove:jh,mouseleave:jh,mouseenter:jh},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Hp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},xu=un({},Hp,{filter:Cp}),Wp=un({},xu,{size:10}),Xp=un({},Hp,{show:!1}),vu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',qp="bold "+vu,Yp=1.5,hp={show:!0,scale:"x",stroke:cu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:qp,side:2,grid:xu,ticks:Wp,border:Xp,font:vu,lineGap:Yp,rotate:0},Ox="Value",Bx="Time",up={show:!0,scale:"x",auto:!1,sorted:1,min:ke,max:-ke,idxs:[]};function kx(i,t,e,n,s){return t.map(r=>r==null?"":pu(r))}function zx(i,t,e,n,s,r,o){let a=[],c=Os.get(s)||0;e=o?e:ze(ll(e,s),c);for(let l=e;l<=n;l=ze(l+s,c))a.push(Object.is(l,-0)?0:l);return a}function su(i,t,e,n,s,r,o){let a=[],c=i.scales[i.axes[t].scale].log,l=c==10?cs:Ep,h=hi(l(e));s=zr(c,h),c==10&&(s=rr[Ci(s,rr)]);let d=e,u=s*c;c==10&&(u=rr[Ci(u,rr)]);do a.push(d),d=d+s,c==10&&!Os.has(d)&&(d=ze(d,Os.get(s))),d>=u&&(s=d,u=s*c,c==10&&(u=rr[Ci(u,rr)]));while(d<=n);return a}function Vx(i,t,e,n,s,r,o){let c=i.scales[i.axes[t].scale].asinh,l=n>c?su(i,t,Kn(c,e),n,s):[c],h=n>=0&&e<=0?[0]:[];return(e<-c?su(i,t,Kn(c,-n),-e,s):[c]).reverse().map(u=>-u).concat(h,l)}var $p=/./,Gx=/[12357]/,Hx=/[125]/,dp=/1/,ru=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function Wx(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],c=i.valToPos,l=r._space,h=c(10,o),d=c(9,o)-h>=l?$p:c(7,o)-h>=l?Gx:c(5,o)-h>=l?Hx:dp;if(d==dp){let u=_n(c(1,o)-h);if(u<l)return ru(t.slice().reverse(),a.distr,d,Si(l/u)).reverse()}return ru(t,a.distr,d,1)}function Xx(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,c=i.valToPos,l=_n(c(1,o)-c(2,o));return l<a?ru(t.slice().reverse(),3,$p,Si(a/l)).reverse():t}function qx(i,t,e,n){return n==null?hu:t==null?"":pu(t)}var fp={show:!0,scale:"y",stroke:cu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:qp,side:3,grid:xu,ticks:Wp,border:Xp,font:vu,lineGap:Yp,rotate:0};function Yx(i,t){let e=3+(i||1)*2;return ze(e*t,3)}function $x(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=_n(o-r),c=i.series[t],l=a/(c.points.space*Ee);return n[1]-n[0]<=l}var pp={scale:null,auto:!0,sorted:0,min:ke,max:-ke},Zp=(i,t,e,n,s)=>s,mp={show:!0,auto:!0,sorted:0,gaps:Zp,alpha:1,facets:[un({},pp,{scale:"x"}),un({},pp,{scale:"y"})]},gp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Zp,alpha:1,points:{show:$x,filter:null},values:null,min:ke,max:-ke,idxs:[],path:null,clip:null};function Zx(i,t,e,n,s){return e/10}var Jp={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Jx=un({},Jp,{time:!1,ori:1}),_p={};function Kp(i,t){let e=_p[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,c,l){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,c,l)}},i!=null&&(_p[i]=e)),e}var Hr=1,ou=2;function cr(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,c=r[0],l=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],d=n==2?o[s.facets[1].scale]:o[s.scale],u=a.left,f=a.top,p=a.width,y=a.height,m=i.valToPosH,g=i.valToPosV;return h.ori==0?e(s,c,l,h,d,m,g,u,f,p,y,ul,Xr,fl,Qp,em):e(s,c,l,h,d,g,m,f,u,y,p,dl,qr,Mu,tm,nm)}function yu(i,t){let e=0,n=0,s=we(i.bands,mu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function Kx(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,c=i.scales[a];return s==-1?c.min:s==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function hs(i,t,e,n,s,r){return cr(i,t,(o,a,c,l,h,d,u,f,p,y,m)=>{let g=o.pxRound,v=l.dir*(l.ori==0?1:-1),A=l.ori==0?Xr:qr,S,C;v==1?(S=e,C=n):(S=n,C=e);let M=g(d(a[S],l,y,f)),_=g(u(c[S],h,m,p)),b=g(d(a[C],l,y,f)),N=g(u(r==1?h.max:h.min,h,m,p)),R=new Path2D(s);return A(R,b,N),A(R,M,N),A(R,M,_),R})}function hl(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?fl:Mu,c=e;for(let d=0;d<i.length;d++){let u=i[d];if(u[1]>u[0]){let f=u[0]-c;f>0&&a(o,c,n,f,n+r),c=u[1]}}let l=e+s-c,h=10;l>0&&a(o,c,n-h/2,l,n+r+h)}return o}function jx(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Su(i,t,e,n,s,r,o){let a=[],c=i.length;for(let l=s==1?e:n;l>=e&&l<=n;l+=s)if(t[l]===null){let d=l,u=l;if(s==1)for(;++l<=n&&t[l]===null;)u=l;else for(;--l>=e&&t[l]===null;)u=l;let f=r(i[d]),p=u==d?f:r(i[u]),y=d-s;f=o<=0&&y>=0&&y<c?r(i[y]):f;let g=u+s;p=o>=0&&g>=0&&g<c?r(i[g]):p,p>=f&&a.push([f,p])}return a}function xp(i){return i==0?Rp:i==1?gn:t=>sr(t,i)}function jp(i){let t=i==0?ul:dl,e=i==0?(s,r,o,a,c,l)=>{s.arcTo(r,o,a,c,l)}:(s,r,o,a,c,l)=>{s.arcTo(o,r,c,a,l)},n=i==0?(s,r,o,a,c)=>{s.rect(r,o,a,c)}:(s,r,o,a,c)=>{s.rect(o,r,c,a)};return(s,r,o,a,c,l=0,h=0)=>{l==0&&h==0?n(s,r,o,a,c):(l=Pi(l,a/2,c/2),h=Pi(h,a/2,c/2),t(s,r+l,o),e(s,r+a,o,r+a,o+c,l),e(s,r+a,o+c,r,o+c,h),e(s,r,o+c,r,o,h),e(s,r,o,r+a,o,l),s.closePath())}}var ul=(i,t,e)=>{i.moveTo(t,e)},dl=(i,t,e)=>{i.moveTo(e,t)},Xr=(i,t,e)=>{i.lineTo(t,e)},qr=(i,t,e)=>{i.lineTo(e,t)},fl=jp(0),Mu=jp(1),Qp=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},tm=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},em=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},nm=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function im(i){return(t,e,n,s,r)=>cr(t,e,(o,a,c,l,h,d,u,f,p,y,m)=>{let{pxRound:g,points:v}=o,A,S;l.ori==0?(A=ul,S=Qp):(A=dl,S=tm);let C=ze(v.width*Ee,3),M=(v.size-v.width)/2*Ee,_=ze(M*2,3),b=new Path2D,N=new Path2D,{left:R,top:P,width:O,height:z}=t.bbox;fl(N,R-_,P-_,O+_*2,z+_*2);let D=H=>{if(c[H]!=null){let W=g(d(a[H],l,y,f)),V=g(u(c[H],h,m,p));A(b,W+M,V),S(b,W,V,M,0,nl*2)}};if(r)r.forEach(D);else for(let H=n;H<=s;H++)D(H);return{stroke:C>0?b:null,fill:b,clip:N,flags:Hr|ou}})}function sm(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var Qx=sm(Xr),tv=sm(qr);function rm(i){let t=we(i?.alignGaps,0);return(e,n,s,r)=>cr(e,n,(o,a,c,l,h,d,u,f,p,y,m)=>{[s,r]=ol(c,s,r);let g=o.pxRound,v=z=>g(d(z,l,y,f)),A=z=>g(u(z,h,m,p)),S,C;l.ori==0?(S=Xr,C=Qx):(S=qr,C=tv);let M=l.dir*(l.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Hr},b=_.stroke,N=!1;if(r-s>=y*4){let z=ot=>e.posToVal(ot,l.key,!0),D=null,H=null,W,V,ht,J=v(a[M==1?s:r]),k=v(a[s]),Q=v(a[r]),lt=z(M==1?k+1:Q-1);for(let ot=M==1?s:r;ot>=s&&ot<=r;ot+=M){let K=a[ot],ft=(M==1?K<lt:K>lt)?J:v(K),_t=c[ot];ft==J?_t!=null?(V=_t,D==null?(S(b,ft,A(V)),W=D=H=V):V<D?D=V:V>H&&(H=V)):_t===null&&(N=!0):(D!=null&&C(b,J,A(D),A(H),A(W),A(V)),_t!=null?(V=_t,S(b,ft,A(V)),D=H=W=V):(D=H=null,_t===null&&(N=!0)),J=ft,lt=z(J+M))}D!=null&&D!=H&&ht!=J&&C(b,J,A(D),A(H),A(W),A(V))}else for(let z=M==1?s:r;z>=s&&z<=r;z+=M){let D=c[z];D===null?N=!0:D!=null&&S(b,v(a[z]),A(D))}let[P,O]=yu(e,n);if(o.fill!=null||P!=0){let z=_.fill=new Path2D(b),D=o.fillTo(e,n,o.min,o.max,P),H=A(D),W=v(a[s]),V=v(a[r]);M==-1&&([V,W]=[W,V]),S(z,V,H),S(z,W,H)}if(!o.spanGaps){let z=[];N&&z.push(...Su(a,c,s,r,M,v,t)),_.gaps=z=o.gaps(e,n,s,r,z),_.clip=hl(z,l.ori,f,p,y,m)}return O!=0&&(_.band=O==2?[hs(e,n,s,r,b,-1),hs(e,n,s,r,b,1)]:hs(e,n,s,r,b,O)),_})}function ev(i){let t=we(i.align,1),e=we(i.ascDesc,!1),n=we(i.alignGaps,0),s=we(i.extend,!1);return(r,o,a,c)=>cr(r,o,(l,h,d,u,f,p,y,m,g,v,A)=>{[a,c]=ol(d,a,c);let S=l.pxRound,{left:C,width:M}=r.bbox,_=k=>S(p(k,u,v,m)),b=k=>S(y(k,f,A,g)),N=u.ori==0?Xr:qr,R={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Hr},P=R.stroke,O=u.dir*(u.ori==0?1:-1),z=b(d[O==1?a:c]),D=_(h[O==1?a:c]),H=D,W=D;s&&t==-1&&(W=C,N(P,W,z)),N(P,D,z);for(let k=O==1?a:c;k>=a&&k<=c;k+=O){let Q=d[k];if(Q==null)continue;let lt=_(h[k]),ot=b(Q);t==1?N(P,lt,z):N(P,H,ot),N(P,lt,ot),z=ot,H=lt}let V=H;s&&t==1&&(V=C+M,N(P,V,z));let[ht,J]=yu(r,o);if(l.fill!=null||ht!=0){let k=R.fill=new Path2D(P),Q=l.fillTo(r,o,l.min,l.max,ht),lt=b(Q);N(k,V,lt),N(k,W,lt)}if(!l.spanGaps){let k=[];k.push(...Su(h,d,a,c,O,_,n));let Q=l.width*Ee/2,lt=e||t==1?Q:-Q,ot=e||t==-1?-Q:Q;k.forEach(K=>{K[0]+=lt,K[1]+=ot}),R.gaps=k=l.gaps(r,o,a,c,k),R.clip=hl(k,u.ori,m,g,v,A)}return J!=0&&(R.band=J==2?[hs(r,o,a,c,P,-1),hs(r,o,a,c,P,1)]:hs(r,o,a,c,P,J)),R})}function vp(i,t,e,n,s,r,o=ke){if(i.length>1){let a=null;for(let c=0,l=1/0;c<i.length;c++)if(t[c]!==void 0){if(a!=null){let h=_n(i[c]-i[a]);h<l&&(l=h,o=_n(e(i[c],n,s,r)-e(i[a],n,s,r)))}a=c}}return o}function nv(i){i=i||Yo;let t=we(i.size,[.6,ke,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=ve(s),o=1-t[0],a=we(t[1],ke),c=we(t[2],1),l=we(i.disp,Yo),h=we(i.each,f=>{}),{fill:d,stroke:u}=l;return(f,p,y,m)=>cr(f,p,(g,v,A,S,C,M,_,b,N,R,P)=>{let O=g.pxRound,z=e,D=n*Ee,H=a*Ee,W=c*Ee,V,ht;S.ori==0?[V,ht]=r(f,p):[ht,V]=r(f,p);let J=S.dir*(S.ori==0?1:-1),k=S.ori==0?fl:Mu,Q=S.ori==0?h:(Ct,Jt,ae,wt,Be,Gt,Yt)=>{h(Ct,Jt,ae,Be,wt,Yt,Gt)},lt=we(f.bands,mu).find(Ct=>Ct.series[0]==p),ot=lt!=null?lt.dir:0,K=g.fillTo(f,p,g.min,g.max,ot),ut=O(_(K,C,P,N)),ft,_t,mt,Bt=R,Kt=O(g.width*Ee),Ft=!1,ce=null,le=null,ne=null,Ne=null;d!=null&&(Kt==0||u!=null)&&(Ft=!0,ce=d.values(f,p,y,m),le=new Map,new Set(ce).forEach(Ct=>{Ct!=null&&le.set(Ct,new Path2D)}),Kt>0&&(ne=u.values(f,p,y,m),Ne=new Map,new Set(ne).forEach(Ct=>{Ct!=null&&Ne.set(Ct,new Path2D)})));let{x0:Ue,size:rn}=l;if(Ue!=null&&rn!=null){z=1,v=Ue.values(f,p,y,m),Ue.unit==2&&(v=v.map(ae=>f.posToVal(b+ae*R,S.key,!0)));let Ct=rn.values(f,p,y,m);rn.unit==2?_t=Ct[0]*R:_t=M(Ct[0],S,R,b)-M(0,S,R,b),Bt=vp(v,A,M,S,R,b,Bt),mt=Bt-_t+D}else Bt=vp(v,A,M,S,R,b,Bt),mt=Bt*o+D,_t=Bt-mt;mt<1&&(mt=0),Kt>=_t/2&&(Kt=0),mt<5&&(O=Rp);let Fe=mt>0,Mn=Bt-mt-(Fe?Kt:0);_t=O(iu(Mn,W,H)),ft=(z==0?_t/2:z==J?0:_t)-z*J*((z==0?D/2:0)+(Fe?Kt/2:0));let Se={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},fn=Ft?null:new Path2D,Je=null;if(lt!=null)Je=f.data[lt.series[1]];else{let{y0:Ct,y1:Jt}=l;Ct!=null&&Jt!=null&&(A=Jt.values(f,p,y,m),Je=Ct.values(f,p,y,m))}let on=V*_t,B=ht*_t;for(let Ct=J==1?y:m;Ct>=y&&Ct<=m;Ct+=J){let Jt=A[Ct];if(Jt==null)continue;if(Je!=null){let $=Je[Ct]??0;if(Jt-$==0)continue;ut=_($,C,P,N)}let ae=S.distr!=2||l!=null?v[Ct]:Ct,wt=M(ae,S,R,b),Be=_(we(Jt,K),C,P,N),Gt=O(wt-ft),Yt=O(Kn(Be,ut)),I=O(Pi(Be,ut)),w=Yt-I;if(Jt!=null){let $=Jt<0?B:on,pt=Jt<0?on:B;Ft?(Kt>0&&ne[Ct]!=null&&k(Ne.get(ne[Ct]),Gt,I+hi(Kt/2),_t,Kn(0,w-Kt),$,pt),ce[Ct]!=null&&k(le.get(ce[Ct]),Gt,I+hi(Kt/2),_t,Kn(0,w-Kt),$,pt)):k(fn,Gt,I+hi(Kt/2),_t,Kn(0,w-Kt),$,pt),Q(f,p,Ct,Gt-Kt/2,I,_t+Kt,w)}}return Kt>0?Se.stroke=Ft?Ne:fn:Ft||(Se._fill=g.width==0?g._fill:g._stroke??g._fill,Se.width=0),Se.fill=Ft?le:fn,Se})}function iv(i,t){let e=we(t?.alignGaps,0);return(n,s,r,o)=>cr(n,s,(a,c,l,h,d,u,f,p,y,m,g)=>{[r,o]=ol(l,r,o);let v=a.pxRound,A=V=>v(u(V,h,m,p)),S=V=>v(f(V,d,g,y)),C,M,_;h.ori==0?(C=ul,_=Xr,M=em):(C=dl,_=qr,M=nm);let b=h.dir*(h.ori==0?1:-1),N=A(c[b==1?r:o]),R=N,P=[],O=[];for(let V=b==1?r:o;V>=r&&V<=o;V+=b)if(l[V]!=null){let J=c[V],k=A(J);P.push(R=k),O.push(S(l[V]))}let z={stroke:i(P,O,C,_,M,v),fill:null,clip:null,band:null,gaps:null,flags:Hr},D=z.stroke,[H,W]=yu(n,s);if(a.fill!=null||H!=0){let V=z.fill=new Path2D(D),ht=a.fillTo(n,s,a.min,a.max,H),J=S(ht);_(V,R,J),_(V,N,J)}if(!a.spanGaps){let V=[];V.push(...Su(c,l,r,o,b,A,e)),z.gaps=V=a.gaps(n,s,r,o,V),z.clip=hl(V,h.ori,p,y,m,g)}return W!=0&&(z.band=W==2?[hs(n,s,r,o,D,-1),hs(n,s,r,o,D,1)]:hs(n,s,r,o,D,W)),z})}function sv(i){return iv(rv,i)}function rv(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let c=Array(o),l=Array(o-1),h=Array(o-1),d=Array(o-1);for(let u=0;u<o-1;u++)h[u]=t[u+1]-t[u],d[u]=i[u+1]-i[u],l[u]=h[u]/d[u];c[0]=l[0];for(let u=1;u<o-1;u++)l[u]===0||l[u-1]===0||l[u-1]>0!=l[u]>0?c[u]=0:(c[u]=3*(d[u-1]+d[u])/((2*d[u]+d[u-1])/l[u-1]+(d[u]+2*d[u-1])/l[u]),isFinite(c[u])||(c[u]=0));c[o-1]=l[o-2];for(let u=0;u<o-1;u++)s(a,i[u]+d[u]/3,t[u]+c[u]*d[u]/3,i[u+1]-d[u]/3,t[u+1]-c[u+1]*d[u]/3,i[u+1],t[u+1])}return a}var au=new Set;function yp(){for(let i of au)i.syncRect(!0)}Wr&&(ar(k_,kr,yp),ar(z_,kr,yp,!0),ar(il,kr,()=>{Rn.pxRatio=Ee}));var ov=rm(),av=im();function Sp(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>lu(r,o,t,e))}function lv(i,t){return i.map((e,n)=>n==0?{}:un({},t,e))}function lu(i,t,e,n){return un({},t==0?e:n,i)}function om(i,t,e){return t==null?Vr:[t,e]}var cv=om;function hv(i,t,e){return t==null?Vr:sl(t,e,fu,!0)}function am(i,t,e,n){return t==null?Vr:al(t,e,i.scales[n].log,!1)}var uv=am;function lm(i,t,e,n){return t==null?Vr:du(t,e,i.scales[n].log,!1)}var dv=lm;function fv(i,t,e,n,s){let r=Kn(Qf(i),Qf(t)),o=t-i,a=Ci(s/n*o,e);do{let c=e[a],l=n*c/o;if(l>=s&&r+(c<5?Os.get(c):0)<=17)return[c,l]}while(++a<e.length);return[0,0]}function Mp(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=gn((e=+s)*Ee))+"px"),[i,t,e]}function pv(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=ze(t[2]*Ee,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Rn(i,t,e){let n={mode:we(i.mode,1)},s=n.mode;function r(x,T,L,U){let X=T.valToPct(x);return U+L*(T.dir==-1?1-X:X)}function o(x,T,L,U){let X=T.valToPct(x);return U+L*(T.dir==-1?X:1-X)}function a(x,T,L,U){return T.ori==0?r(x,T,L,U):o(x,T,L,U)}n.valToPosH=r,n.valToPosV=o;let c=!1;n.status=0;let l=n.root=yi(S_);if(i.id!=null&&(l.id=i.id),ci(l,i.class),i.title){let x=yi(w_,l);x.textContent=i.title}let h=Ri("canvas"),d=n.ctx=h.getContext("2d"),u=yi(T_,l);ar("click",u,x=>{x.target===p&&(Ge!=Ir||Ye!=Lr)&&In.click(n,x)},!0);let f=n.under=yi(E_,u);u.appendChild(h);let p=n.over=yi(A_,u);i=Gr(i);let y=+we(i.pxAlign,1),m=xp(y);(i.plugins||[]).forEach(x=>{x.opts&&(i=x.opts(n,i)||i)});let g=i.ms||.001,v=n.series=s==1?Sp(i.series||[],up,gp,!1):lv(i.series||[null],mp),A=n.axes=Sp(i.axes||[],hp,fp,!0),S=n.scales={},C=n.bands=i.bands||[];C.forEach(x=>{x.fill=ve(x.fill||null),x.dir=we(x.dir,-1)});let M=s==2?v[1].facets[0].scale:v[0].scale,_={axes:ss,series:me},b=(i.drawOrder||["axes","series"]).map(x=>_[x]);function N(x){let T=x.distr==3?L=>cs(L>0?L:x.clamp(n,L,x.min,x.max,x.key)):x.distr==4?L=>Zh(L,x.asinh):x.distr==100?L=>x.fwd(L):L=>L;return L=>{let U=T(L),{_min:X,_max:tt}=x,ct=tt-X;return(U-X)/ct}}function R(x){let T=S[x];if(T==null){let L=(i.scales||Yo)[x]||Yo;if(L.from!=null){R(L.from);let U=un({},S[L.from],L,{key:x});U.valToPct=N(U),S[x]=U}else{T=S[x]=un({},x==M?Jp:Jx,L),T.key=x;let U=T.time,X=T.range,tt=Fs(X);if((x!=M||s==2&&!U)&&(tt&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Jf:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Jf:{mode:1,hard:X[1],soft:X[1]}},tt=!1),!tt&&cl(X))){let ct=X;X=(gt,Mt,Dt)=>Mt==null?Vr:sl(Mt,Dt,ct)}T.range=ve(X||(U?cv:x==M?T.distr==3?uv:T.distr==4?dv:om:T.distr==3?am:T.distr==4?lm:hv)),T.auto=ve(tt?!1:T.auto),T.clamp=ve(T.clamp||Zx),T._min=T._max=null,T.valToPct=N(T)}}}R("x"),R("y"),s==1&&v.forEach(x=>{R(x.scale)}),A.forEach(x=>{R(x.scale)});for(let x in i.scales)R(x);let P=S[M],O=P.distr,z,D;P.ori==0?(ci(l,M_),z=r,D=o):(ci(l,b_),z=o,D=r);let H={};for(let x in S){let T=S[x];(T.min!=null||T.max!=null)&&(H[x]={min:T.min,max:T.max},T.min=T.max=null)}let W=i.tzDate||(x=>new Date(gn(x/g))),V=i.fmtDate||gu,ht=g==1?Mx(W):Tx(W),J=ap(W,op(g==1?Sx:wx,V)),k=cp(W,lp(Ax,V)),Q=[],lt=n.legend=un({},Px,i.legend),ot=n.cursor=un({},Fx,{drag:{y:s==2}},i.cursor),K=lt.show,ut=ot.show,ft=lt.markers;lt.idxs=Q,ft.width=ve(ft.width),ft.dash=ve(ft.dash),ft.stroke=ve(ft.stroke),ft.fill=ve(ft.fill);let _t,mt,Bt,Kt=[],Ft=[],ce,le=!1,ne={};if(lt.live){let x=v[1]?v[1].values:null;le=x!=null,ce=le?x(n,1,0):{_:0};for(let T in ce)ne[T]=hu}if(K)if(_t=Ri("table",D_,l),Bt=Ri("tbody",null,_t),lt.mount(n,_t),le){mt=Ri("thead",null,_t,Bt);let x=Ri("tr",null,mt);Ri("th",null,x);for(var Ne in ce)Ri("th",Of,x).textContent=Ne}else ci(_t,U_),lt.live&&ci(_t,N_);let Ue={show:!0},rn={show:!1};function Fe(x,T){if(T==0&&(le||!lt.live||s==2))return Vr;let L=[],U=Ri("tr",F_,Bt,Bt.childNodes[T]);ci(U,x.class),x.show||ci(U,or);let X=Ri("th",null,U);if(ft.show){let gt=yi(O_,X);if(T>0){let Mt=ft.width(n,T);Mt&&(gt.style.border=Mt+"px "+ft.dash(n,T)+" "+ft.stroke(n,T)),gt.style.background=ft.fill(n,T)}}let tt=yi(Of,X);x.label instanceof HTMLElement?tt.appendChild(x.label):tt.textContent=x.label,T>0&&(ft.show||(tt.style.color=x.width>0?ft.stroke(n,T):ft.fill(n,T)),Se("click",X,gt=>{if(ot._lock)return;Qt(gt);let Mt=v.indexOf(x);if((gt.ctrlKey||gt.metaKey)!=lt.isolate){let Dt=v.some((Nt,Ot)=>Ot>0&&Ot!=Mt&&Nt.show);v.forEach((Nt,Ot)=>{Ot>0&&Gi(Ot,Dt?Ot==Mt?Ue:rn:Ue,!0,hn.setSeries)})}else Gi(Mt,{show:!x.show},!0,hn.setSeries)},!1),te&&Se(Vf,X,gt=>{ot._lock||(Qt(gt),Gi(v.indexOf(x),Nr,!0,hn.setSeries))},!1));for(var ct in ce){let gt=Ri("td",B_,U);gt.textContent="--",L.push(gt)}return[U,L]}let Mn=new Map;function Se(x,T,L,U=!0){let X=Mn.get(T)||{},tt=ot.bind[x](n,T,L,U);tt&&(ar(x,T,X[x]=tt),Mn.set(T,X))}function fn(x,T,L){let U=Mn.get(T)||{};for(let X in U)(x==null||X==x)&&(nu(X,T,U[X]),delete U[X]);x==null&&Mn.delete(T)}let Je=0,on=0,B=0,Ct=0,Jt=0,ae=0,wt=Jt,Be=ae,Gt=B,Yt=Ct,I=0,w=0,$=0,pt=0;n.bbox={};let at=!1,yt=!1,St=!1,nt=!1,st=!1,xt=!1;function F(x,T,L){(L||x!=n.width||T!=n.height)&&rt(x,T),ue(!1),St=!0,yt=!0,Nn()}function rt(x,T){n.width=Je=B=x,n.height=on=Ct=T,Jt=ae=0,bt(),Ht();let L=n.bbox;I=L.left=sr(Jt*Ee,.5),w=L.top=sr(ae*Ee,.5),$=L.width=sr(B*Ee,.5),pt=L.height=sr(Ct*Ee,.5)}let it=3;function Tt(){let x=!1,T=0;for(;!x;){T++;let L=Rr(T),U=Vi(T);x=T==it||L&&U,x||(rt(n.width,n.height),yt=!0)}}function vt({width:x,height:T}){F(x,T)}n.setSize=vt;function bt(){let x=!1,T=!1,L=!1,U=!1;A.forEach((X,tt)=>{if(X.show&&X._show){let{side:ct,_size:gt}=X,Mt=ct%2,Dt=X.label!=null?X.labelSize:0,Nt=gt+Dt;Nt>0&&(Mt?(B-=Nt,ct==3?(Jt+=Nt,U=!0):L=!0):(Ct-=Nt,ct==0?(ae+=Nt,x=!0):T=!0))}}),ki[0]=x,ki[1]=L,ki[2]=T,ki[3]=U,B-=Ti[1]+Ti[3],Jt+=Ti[3],Ct-=Ti[2]+Ti[0],ae+=Ti[0]}function Ht(){let x=Jt+B,T=ae+Ct,L=Jt,U=ae;function X(tt,ct){switch(tt){case 1:return x+=ct,x-ct;case 2:return T+=ct,T-ct;case 3:return L-=ct,L+ct;case 0:return U-=ct,U+ct}}A.forEach((tt,ct)=>{if(tt.show&&tt._show){let gt=tt.side;tt._pos=X(gt,tt._size),tt.label!=null&&(tt._lpos=X(gt,tt.labelSize))}})}if(ot.dataIdx==null){let x=ot.hover,T=x.skip=new Set(x.skip??[]);T.add(void 0);let L=x.prox=ve(x.prox),U=x.bias??=0;ot.dataIdx=(X,tt,ct,gt)=>{if(tt==0)return ct;let Mt=ct,Dt=L(X,tt,ct,gt)??ke,Nt=Dt>=0&&Dt<ke,Ot=P.ori==0?B:Ct,oe=ot.left,Te=t[0],be=t[tt];if(T.has(be[ct])){Mt=null;let _e=null,jt=null,Xt;if(U==0||U==-1)for(Xt=ct;_e==null&&Xt-- >0;)T.has(be[Xt])||(_e=Xt);if(U==0||U==1)for(Xt=ct;jt==null&&Xt++<be.length;)T.has(be[Xt])||(jt=Xt);if(_e!=null||jt!=null)if(Nt){let We=_e==null?-1/0:z(Te[_e],P,Ot,0),Qe=jt==null?1/0:z(Te[jt],P,Ot,0),En=oe-We,Oe=Qe-oe;En<=Oe?En<=Dt&&(Mt=_e):Oe<=Dt&&(Mt=jt)}else Mt=jt==null?_e:_e==null?jt:ct-_e<=jt-ct?_e:jt}else Nt&&_n(oe-z(Te[ct],P,Ot,0))>Dt&&(Mt=null);return Mt}}let Qt=x=>{ot.event=x};ot.idxs=Q,ot._lock=!1;let dt=ot.points;dt.show=ve(dt.show),dt.size=ve(dt.size),dt.stroke=ve(dt.stroke),dt.width=ve(dt.width),dt.fill=ve(dt.fill);let kt=n.focus=un({},i.focus||{alpha:.3},ot.focus),te=kt.prox>=0,Rt=te&&dt.one,he=[],Ve=[],qn=[];function Io(x,T){let L=dt.show(n,T);if(L instanceof HTMLElement)return ci(L,L_),ci(L,x.class),Yi(L,-10,-10,B,Ct),p.insertBefore(L,he[T]),L}function Tr(x,T){if(s==1||T>0){let L=s==1&&S[x.scale].time,U=x.value;x.value=L?np(U)?cp(W,lp(U,V)):U||k:U||qx,x.label=x.label||(L?Bx:Ox)}if(Rt||T>0){x.width=x.width==null?1:x.width,x.paths=x.paths||ov||J_,x.fillTo=ve(x.fillTo||Kx),x.pxAlign=+we(x.pxAlign,y),x.pxRound=xp(x.pxAlign),x.stroke=ve(x.stroke||null),x.fill=ve(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let L=Yx(Kn(1,x.width),1),U=x.points=un({},{size:L,width:Kn(1,L*.2),stroke:x.stroke,space:L*2,paths:av,_stroke:null,_fill:null},x.points);U.show=ve(U.show),U.filter=ve(U.filter),U.fill=ve(U.fill),U.stroke=ve(U.stroke),U.paths=ve(U.paths),U.pxAlign=x.pxAlign}if(K){let L=Fe(x,T);Kt.splice(T,0,L[0]),Ft.splice(T,0,L[1]),lt.values.push(null)}if(ut){Q.splice(T,0,null);let L=null;Rt?T==0&&(L=Io(x,T)):T>0&&(L=Io(x,T)),he.splice(T,0,L),Ve.splice(T,0,0),qn.splice(T,0,0)}Tn("addSeries",T)}function Eh(x,T){T=T??v.length,x=s==1?lu(x,T,up,gp):lu(x,T,{},mp),v.splice(T,0,x),Tr(v[T],T)}n.addSeries=Eh;function Va(x){if(v.splice(x,1),K){lt.values.splice(x,1),Ft.splice(x,1);let T=Kt.splice(x,1)[0];fn(null,T.firstChild),T.remove()}ut&&(Q.splice(x,1),he.splice(x,1)[0].remove(),Ve.splice(x,1),qn.splice(x,1)),Tn("delSeries",x)}n.delSeries=Va;let ki=[!1,!1,!1,!1];function es(x,T){if(x._show=x.show,x.show){let L=x.side%2,U=S[x.scale];U==null&&(x.scale=L?v[1].scale:M,U=S[x.scale]);let X=U.time;x.size=ve(x.size),x.space=ve(x.space),x.rotate=ve(x.rotate),Fs(x.incrs)&&x.incrs.forEach(ct=>{!Os.has(ct)&&Os.set(ct,Ip(ct))}),x.incrs=ve(x.incrs||(U.distr==2?xx:X?g==1?yx:bx:rr)),x.splits=ve(x.splits||(X&&U.distr==1?ht:U.distr==3?su:U.distr==4?Vx:zx)),x.stroke=ve(x.stroke),x.grid.stroke=ve(x.grid.stroke),x.ticks.stroke=ve(x.ticks.stroke),x.border.stroke=ve(x.border.stroke);let tt=x.values;x.values=Fs(tt)&&!Fs(tt[0])?ve(tt):X?Fs(tt)?ap(W,op(tt,V)):np(tt)?Ex(W,tt):tt||J:tt||kx,x.filter=ve(x.filter||(U.distr>=3&&U.log==10?Wx:U.distr==3&&U.log==2?Xx:Cp)),x.font=Mp(x.font),x.labelFont=Mp(x.labelFont),x._size=x.size(n,null,T,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(ki[T]=!0,x._el=yi(R_,u))}}function ns(x,T,L,U){let[X,tt,ct,gt]=L,Mt=T%2,Dt=0;return Mt==0&&(gt||tt)&&(Dt=T==0&&!X||T==2&&!ct?gn(hp.size/3):0),Mt==1&&(X||ct)&&(Dt=T==1&&!tt||T==3&&!gt?gn(fp.size/2):0),Dt}let Lo=n.padding=(i.padding||[ns,ns,ns,ns]).map(x=>ve(we(x,ns))),Ti=n._padding=Lo.map((x,T)=>x(n,T,ki,0)),Ke,nn=null,sn=null,zi=s==1?v[0].idxs:null,ri=null,Rs=!1;function Do(x,T){if(t=x??[],n.data=n._data=t,s==2){Ke=0;for(let L=1;L<v.length;L++)Ke+=t[L][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),ri=t[0],Ke=ri.length;let L=t;if(O==2){L=t.slice();let U=L[0]=Array(Ke);for(let X=0;X<Ke;X++)U[X]=X}n._data=t=L}if(ue(!0),Tn("setData"),O==2&&(St=!0),T!==!1){let L=P;L.auto(n,Rs)?No():Is(M,L.min,L.max),nt=nt||ot.left>=0,xt=!0,Nn()}}n.setData=Do;function No(){Rs=!0;let x,T;s==1&&(Ke>0?(nn=zi[0]=0,sn=zi[1]=Ke-1,x=t[0][nn],T=t[0][sn],O==2?(x=nn,T=sn):x==T&&(O==3?[x,T]=al(x,x,P.log,!1):O==4?[x,T]=du(x,x,P.log,!1):P.time?T=x+gn(86400/g):[x,T]=sl(x,T,fu,!0))):(nn=zi[0]=x=null,sn=zi[1]=T=null)),Is(M,x,T)}let Er,Cs,Ar,E,G,et,Z,j,Et,Pt;function At(x,T,L,U,X,tt){x??=kf,L??=mu,U??="butt",X??=kf,tt??="round",x!=Er&&(d.strokeStyle=Er=x),X!=Cs&&(d.fillStyle=Cs=X),T!=Ar&&(d.lineWidth=Ar=T),tt!=G&&(d.lineJoin=G=tt),U!=et&&(d.lineCap=et=U),L!=E&&d.setLineDash(E=L)}function It(x,T,L,U){T!=Cs&&(d.fillStyle=Cs=T),x!=Z&&(d.font=Z=x),L!=j&&(d.textAlign=j=L),U!=Et&&(d.textBaseline=Et=U)}function Vt(x,T,L,U,X=0){if(U.length>0&&x.auto(n,Rs)&&(T==null||T.min==null)){let tt=we(nn,0),ct=we(sn,U.length-1),gt=L.min==null?W_(U,tt,ct,X,x.distr==3):[L.min,L.max];x.min=Pi(x.min,L.min=gt[0]),x.max=Kn(x.max,L.max=gt[1])}}let ie={min:null,max:null};function pe(){for(let U in S){let X=S[U];H[U]==null&&(X.min==null||H[M]!=null&&X.auto(n,Rs))&&(H[U]=ie)}for(let U in S){let X=S[U];H[U]==null&&X.from!=null&&H[X.from]!=null&&(H[U]=ie)}H[M]!=null&&ue(!0);let x={};for(let U in H){let X=H[U];if(X!=null){let tt=x[U]=Gr(S[U],Q_);if(X.min!=null)un(tt,X);else if(U!=M||s==2)if(Ke==0&&tt.from==null){let ct=tt.range(n,null,null,U);tt.min=ct[0],tt.max=ct[1]}else tt.min=ke,tt.max=-ke}}if(Ke>0){v.forEach((U,X)=>{if(s==1){let tt=U.scale,ct=H[tt];if(ct==null)return;let gt=x[tt];if(X==0){let Mt=gt.range(n,gt.min,gt.max,tt);gt.min=Mt[0],gt.max=Mt[1],nn=Ci(gt.min,t[0]),sn=Ci(gt.max,t[0]),sn-nn>1&&(t[0][nn]<gt.min&&nn++,t[0][sn]>gt.max&&sn--),U.min=ri[nn],U.max=ri[sn]}else U.show&&U.auto&&Vt(gt,ct,U,t[X],U.sorted);U.idxs[0]=nn,U.idxs[1]=sn}else if(X>0&&U.show&&U.auto){let[tt,ct]=U.facets,gt=tt.scale,Mt=ct.scale,[Dt,Nt]=t[X],Ot=x[gt],oe=x[Mt];Ot!=null&&Vt(Ot,H[gt],tt,Dt,tt.sorted),oe!=null&&Vt(oe,H[Mt],ct,Nt,ct.sorted),U.min=ct.min,U.max=ct.max}});for(let U in x){let X=x[U],tt=H[U];if(X.from==null&&(tt==null||tt.min==null)){let ct=X.range(n,X.min==ke?null:X.min,X.max==-ke?null:X.max,U);X.min=ct[0],X.max=ct[1]}}}for(let U in x){let X=x[U];if(X.from!=null){let tt=x[X.from];if(tt.min==null)X.min=X.max=null;else{let ct=X.range(n,tt.min,tt.max,U);X.min=ct[0],X.max=ct[1]}}}let T={},L=!1;for(let U in x){let X=x[U],tt=S[U];if(tt.min!=X.min||tt.max!=X.max){tt.min=X.min,tt.max=X.max;let ct=tt.distr;tt._min=ct==3?cs(tt.min):ct==4?Zh(tt.min,tt.asinh):ct==100?tt.fwd(tt.min):tt.min,tt._max=ct==3?cs(tt.max):ct==4?Zh(tt.max,tt.asinh):ct==100?tt.fwd(tt.max):tt.max,T[U]=L=!0}}if(L){v.forEach((U,X)=>{s==2?X>0&&T.y&&(U._paths=null):T[U.scale]&&(U._paths=null)});for(let U in T)St=!0,Tn("setScale",U);ut&&ot.left>=0&&(nt=xt=!0)}for(let U in H)H[U]=null}function zt(x){let T=iu(nn-1,0,Ke-1),L=iu(sn+1,0,Ke-1);for(;x[T]==null&&T>0;)T--;for(;x[L]==null&&L<Ke-1;)L++;return[T,L]}function me(){if(Ke>0){let x=v.some(T=>T._focus)&&Pt!=kt.alpha;x&&(d.globalAlpha=Pt=kt.alpha),v.forEach((T,L)=>{if(L>0&&T.show&&(Ze(L,!1),Ze(L,!0),T._paths==null)){let U=Pt;Pt!=T.alpha&&(d.globalAlpha=Pt=T.alpha);let X=s==2?[0,t[L][0].length-1]:zt(t[L]);T._paths=T.paths(n,L,X[0],X[1]),Pt!=U&&(d.globalAlpha=Pt=U)}}),v.forEach((T,L)=>{if(L>0&&T.show){let U=Pt;Pt!=T.alpha&&(d.globalAlpha=Pt=T.alpha),T._paths!=null&&Ie(L,!1);{let X=T._paths!=null?T._paths.gaps:null,tt=T.points.show(n,L,nn,sn,X),ct=T.points.filter(n,L,tt,X);(tt||ct)&&(T.points._paths=T.points.paths(n,L,nn,sn,ct),Ie(L,!0))}Pt!=U&&(d.globalAlpha=Pt=U),Tn("drawSeries",L)}}),x&&(d.globalAlpha=Pt=1)}}function Ze(x,T){let L=T?v[x].points:v[x];L._stroke=L.stroke(n,x),L._fill=L.fill(n,x)}function Ie(x,T){let L=T?v[x].points:v[x],{stroke:U,fill:X,clip:tt,flags:ct,_stroke:gt=L._stroke,_fill:Mt=L._fill,_width:Dt=L.width}=L._paths;Dt=ze(Dt*Ee,3);let Nt=null,Ot=Dt%2/2;T&&Mt==null&&(Mt=Dt>0?"#fff":gt);let oe=L.pxAlign==1&&Ot>0;if(oe&&d.translate(Ot,Ot),!T){let Te=I-Dt/2,be=w-Dt/2,_e=$+Dt,jt=pt+Dt;Nt=new Path2D,Nt.rect(Te,be,_e,jt)}T?Ut(gt,Dt,L.dash,L.cap,Mt,U,X,ct,tt):Le(x,gt,Dt,L.dash,L.cap,Mt,U,X,ct,Nt,tt),oe&&d.translate(-Ot,-Ot)}function Le(x,T,L,U,X,tt,ct,gt,Mt,Dt,Nt){let Ot=!1;Mt!=0&&C.forEach((oe,Te)=>{if(oe.series[0]==x){let be=v[oe.series[1]],_e=t[oe.series[1]],jt=(be._paths||Yo).band;Fs(jt)&&(jt=oe.dir==1?jt[0]:jt[1]);let Xt,We=null;be.show&&jt&&q_(_e,nn,sn)?(We=oe.fill(n,Te)||tt,Xt=be._paths.clip):jt=null,Ut(T,L,U,X,We,ct,gt,Mt,Dt,Nt,Xt,jt),Ot=!0}}),Ot||Ut(T,L,U,X,tt,ct,gt,Mt,Dt,Nt)}let pn=Hr|ou;function Ut(x,T,L,U,X,tt,ct,gt,Mt,Dt,Nt,Ot){At(x,T,L,U,X),(Mt||Dt||Ot)&&(d.save(),Mt&&d.clip(Mt),Dt&&d.clip(Dt)),Ot?(gt&pn)==pn?(d.clip(Ot),Nt&&d.clip(Nt),xe(X,ct),an(x,tt,T)):gt&ou?(xe(X,ct),d.clip(Ot),an(x,tt,T)):gt&Hr&&(d.save(),d.clip(Ot),Nt&&d.clip(Nt),xe(X,ct),d.restore(),an(x,tt,T)):(xe(X,ct),an(x,tt,T)),(Mt||Dt||Ot)&&d.restore()}function an(x,T,L){L>0&&(T instanceof Map?T.forEach((U,X)=>{d.strokeStyle=Er=X,d.stroke(U)}):T!=null&&x&&d.stroke(T))}function xe(x,T){T instanceof Map?T.forEach((L,U)=>{d.fillStyle=Cs=U,d.fill(L)}):T!=null&&x&&d.fill(T)}function is(x,T,L,U){let X=A[x],tt;if(U<=0)tt=[0,0];else{let ct=X._space=X.space(n,x,T,L,U),gt=X._incrs=X.incrs(n,x,T,L,U,ct);tt=fv(T,L,gt,U,ct)}return X._found=tt}function ln(x,T,L,U,X,tt,ct,gt,Mt,Dt){let Nt=ct%2/2;y==1&&d.translate(Nt,Nt),At(gt,ct,Mt,Dt,gt),d.beginPath();let Ot,oe,Te,be,_e=X+(U==0||U==3?-tt:tt);L==0?(oe=X,be=_e):(Ot=X,Te=_e);for(let jt=0;jt<x.length;jt++)T[jt]!=null&&(L==0?Ot=Te=x[jt]:oe=be=x[jt],d.moveTo(Ot,oe),d.lineTo(Te,be));d.stroke(),y==1&&d.translate(-Nt,-Nt)}function Rr(x){let T=!0;return A.forEach((L,U)=>{if(!L.show)return;let X=S[L.scale];if(X.min==null){L._show&&(T=!1,L._show=!1,ue(!1));return}else L._show||(T=!1,L._show=!0,ue(!1));let tt=L.side,ct=tt%2,{min:gt,max:Mt}=X,[Dt,Nt]=is(U,gt,Mt,ct==0?B:Ct);if(Nt==0)return;let Ot=X.distr==2,oe=L._splits=L.splits(n,U,gt,Mt,Dt,Nt,Ot),Te=X.distr==2?oe.map(Xt=>ri[Xt]):oe,be=X.distr==2?ri[oe[1]]-ri[oe[0]]:Dt,_e=L._values=L.values(n,L.filter(n,Te,U,Nt,be),U,Nt,be);L._rotate=tt==2?L.rotate(n,_e,U,Nt):0;let jt=L._size;L._size=Si(L.size(n,_e,U,x)),jt!=null&&L._size!=jt&&(T=!1)}),T}function Vi(x){let T=!0;return Lo.forEach((L,U)=>{let X=L(n,U,ki,x);X!=Ti[U]&&(T=!1),Ti[U]=X}),T}function ss(){for(let x=0;x<A.length;x++){let T=A[x];if(!T.show||!T._show)continue;let L=T.side,U=L%2,X,tt,ct=T.stroke(n,x),gt=L==0||L==3?-1:1,[Mt,Dt]=T._found;if(T.label!=null){let Zn=T.labelGap*gt,li=gn((T._lpos+Zn)*Ee);It(T.labelFont[0],ct,"center",L==2?"top":Bf),d.save(),U==1?(X=tt=0,d.translate(li,gn(w+pt/2)),d.rotate((L==3?-nl:nl)/2)):(X=gn(I+$/2),tt=li);let nr=Ap(T.label)?T.label(n,x,Mt,Dt):T.label;d.fillText(nr,X,tt),d.restore()}if(Dt==0)continue;let Nt=S[T.scale],Ot=U==0?$:pt,oe=U==0?I:w,Te=T._splits,be=Nt.distr==2?Te.map(Zn=>ri[Zn]):Te,_e=Nt.distr==2?ri[Te[1]]-ri[Te[0]]:Mt,jt=T.ticks,Xt=T.border,We=jt.show?jt.size:0,Qe=gn(We*Ee),En=gn((T.alignTo==2?T._size-We-T.gap:T.gap)*Ee),Oe=T._rotate*-nl/180,tn=m(T._pos*Ee),oi=(Qe+En)*gt,$n=tn+oi;tt=U==0?$n:0,X=U==1?$n:0;let xi=T.font[0],Ei=T.align==1?Or:T.align==2?qh:Oe>0?Or:Oe<0?qh:U==0?"center":L==3?qh:Or,Wi=Oe||U==1?"middle":L==2?"top":Bf;It(xi,ct,Ei,Wi);let ai=T.font[1]*T.lineGap,vi=Te.map(Zn=>m(a(Zn,Nt,Ot,oe))),Ai=T._values;for(let Zn=0;Zn<Ai.length;Zn++){let li=Ai[Zn];if(li!=null){U==0?X=vi[Zn]:tt=vi[Zn],li=""+li;let nr=li.indexOf(`
`)==-1?[li]:li.split(/\n/gm);for(let Jn=0;Jn<nr.length;Jn++){let mf=nr[Jn];Oe?(d.save(),d.translate(X,tt+Jn*ai),d.rotate(Oe),d.fillText(mf,0,0),d.restore()):d.fillText(mf,X,tt+Jn*ai)}}}jt.show&&ln(vi,jt.filter(n,be,x,Dt,_e),U,L,tn,Qe,ze(jt.width*Ee,3),jt.stroke(n,x),jt.dash,jt.cap);let Xi=T.grid;Xi.show&&ln(vi,Xi.filter(n,be,x,Dt,_e),U,U==0?2:1,U==0?w:I,U==0?pt:$,ze(Xi.width*Ee,3),Xi.stroke(n,x),Xi.dash,Xi.cap),Xt.show&&ln([tn],[1],U==0?1:0,U==0?1:2,U==1?w:I,U==1?pt:$,ze(Xt.width*Ee,3),Xt.stroke(n,x),Xt.dash,Xt.cap)}Tn("drawAxes")}function ue(x){v.forEach((T,L)=>{L>0&&(T._paths=null,x&&(s==1?(T.min=null,T.max=null):T.facets.forEach(U=>{U.min=null,U.max=null})))})}let je=!1,Yn=!1,De=[];function cn(){Yn=!1;for(let x=0;x<De.length;x++)Tn(...De[x]);De.length=0}function Nn(){je||(ox(Jd),je=!0)}function Ga(x,T=!1){je=!0,Yn=T,x(n),Jd(),T&&De.length>0&&queueMicrotask(cn)}n.batch=Ga;function Jd(){if(at&&(pe(),at=!1),St&&(Tt(),St=!1),yt){if(Xe(f,Or,Jt),Xe(f,"top",ae),Xe(f,Ho,B),Xe(f,Wo,Ct),Xe(p,Or,Jt),Xe(p,"top",ae),Xe(p,Ho,B),Xe(p,Wo,Ct),Xe(u,Ho,Je),Xe(u,Wo,on),h.width=gn(Je*Ee),h.height=gn(on*Ee),A.forEach(({_el:x,_show:T,_size:L,_pos:U,side:X})=>{if(x!=null)if(T){let tt=X===3||X===0?L:0,ct=X%2==1;Xe(x,ct?"left":"top",U-tt),Xe(x,ct?"width":"height",L),Xe(x,ct?"top":"left",ct?ae:Jt),Xe(x,ct?"height":"width",ct?Ct:B),eu(x,or)}else ci(x,or)}),Er=Cs=Ar=G=et=Z=j=Et=E=null,Pt=1,Oo(!0),Jt!=wt||ae!=Be||B!=Gt||Ct!=Yt){ue(!1);let x=B/Gt,T=Ct/Yt;if(ut&&!nt&&ot.left>=0){ot.left*=x,ot.top*=T,Cr&&Yi(Cr,gn(ot.left),0,B,Ct),Pr&&Yi(Pr,0,gn(ot.top),B,Ct);for(let L=0;L<he.length;L++){let U=he[L];U!=null&&(Ve[L]*=x,qn[L]*=T,Yi(U,Si(Ve[L]),Si(qn[L]),B,Ct))}}if(He.show&&!st&&He.left>=0&&He.width>0){He.left*=x,He.width*=x,He.top*=T,He.height*=T;for(let L in Lh)Xe(Dr,L,He[L])}wt=Jt,Be=ae,Gt=B,Yt=Ct}Tn("setSize"),yt=!1}Je>0&&on>0&&(d.clearRect(0,0,h.width,h.height),Tn("drawClear"),b.forEach(x=>x()),Tn("draw")),He.show&&st&&(Ha(He),st=!1),ut&&nt&&(er(null,!0,!1),nt=!1),lt.show&&lt.live&&xt&&(Ph(),xt=!1),c||(c=!0,n.status=1,Tn("ready")),Rs=!1,je=!1}n.redraw=(x,T)=>{St=T||!1,x!==!1?Is(M,P.min,P.max):Nn()};function Ah(x,T){let L=S[x];if(L.from==null){if(Ke==0){let U=L.range(n,T.min,T.max,x);T.min=U[0],T.max=U[1]}if(T.min>T.max){let U=T.min;T.min=T.max,T.max=U}if(Ke>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;x==M&&L.distr==2&&Ke>0&&(T.min=Ci(T.min,t[0]),T.max=Ci(T.max,t[0]),T.min==T.max&&T.max++),H[x]=T,at=!0,Nn()}}n.setScale=Ah;let Rh,Ch,Cr,Pr,Kd,jd,Ir,Lr,Qd,tf,Ge,Ye,Ps=!1,In=ot.drag,bn=In.x,wn=In.y;ut&&(ot.x&&(Rh=yi(P_,p)),ot.y&&(Ch=yi(I_,p)),P.ori==0?(Cr=Rh,Pr=Ch):(Cr=Ch,Pr=Rh),Ge=ot.left,Ye=ot.top);let He=n.select=un({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Dr=He.show?yi(C_,He.over?p:f):null;function Ha(x,T){if(He.show){for(let L in x)He[L]=x[L],L in Lh&&Xe(Dr,L,x[L]);T!==!1&&Tn("setSelect")}}n.setSelect=Ha;function H0(x){if(v[x].show)K&&eu(Kt[x],or);else if(K&&ci(Kt[x],or),ut){let L=Rt?he[0]:he[x];L!=null&&Yi(L,-10,-10,B,Ct)}}function Is(x,T,L){Ah(x,{min:T,max:L})}function Gi(x,T,L,U){T.focus!=null&&$0(x),T.show!=null&&v.forEach((X,tt)=>{tt>0&&(x==tt||x==null)&&(X.show=T.show,H0(tt),s==2?(Is(X.facets[0].scale,null,null),Is(X.facets[1].scale,null,null)):Is(X.scale,null,null),Nn())}),L!==!1&&Tn("setSeries",x,T),U&&Bo("setSeries",n,x,T)}n.setSeries=Gi;function W0(x,T){un(C[x],T)}function X0(x,T){x.fill=ve(x.fill||null),x.dir=we(x.dir,-1),T=T??C.length,C.splice(T,0,x)}function q0(x){x==null?C.length=0:C.splice(x,1)}n.addBand=X0,n.setBand=W0,n.delBand=q0;function Y0(x,T){v[x].alpha=T,ut&&he[x]!=null&&(he[x].style.opacity=T),K&&Kt[x]&&(Kt[x].style.opacity=T)}let rs,Ls,tr,Nr={focus:!0};function $0(x){if(x!=tr){let T=x==null,L=kt.alpha!=1;v.forEach((U,X)=>{if(s==1||X>0){let tt=T||X==0||X==x;U._focus=T?null:tt,L&&Y0(X,tt?1:kt.alpha)}}),tr=x,L&&Nn()}}K&&te&&Se(Gf,_t,x=>{ot._lock||(Qt(x),tr!=null&&Gi(null,Nr,!0,hn.setSeries))});function Hi(x,T,L){let U=S[T];L&&(x=x/Ee-(U.ori==1?ae:Jt));let X=B;U.ori==1&&(X=Ct,x=X-x),U.dir==-1&&(x=X-x);let tt=U._min,ct=U._max,gt=x/X,Mt=tt+(ct-tt)*gt,Dt=U.distr;return Dt==3?zr(10,Mt):Dt==4?$_(Mt,U.asinh):Dt==100?U.bwd(Mt):Mt}function Z0(x,T){let L=Hi(x,M,T);return Ci(L,t[0],nn,sn)}n.valToIdx=x=>Ci(x,t[0]),n.posToIdx=Z0,n.posToVal=Hi,n.valToPos=(x,T,L)=>S[T].ori==0?r(x,S[T],L?$:B,L?I:0):o(x,S[T],L?pt:Ct,L?w:0),n.setCursor=(x,T,L)=>{Ge=x.left,Ye=x.top,er(null,T,L)};function ef(x,T){Xe(Dr,Or,He.left=x),Xe(Dr,Ho,He.width=T)}function nf(x,T){Xe(Dr,"top",He.top=x),Xe(Dr,Wo,He.height=T)}let Uo=P.ori==0?ef:nf,Fo=P.ori==1?ef:nf;function J0(){if(K&&lt.live)for(let x=s==2?1:0;x<v.length;x++){if(x==0&&le)continue;let T=lt.values[x],L=0;for(let U in T)Ft[x][L++].firstChild.nodeValue=T[U]}}function Ph(x,T){if(x!=null&&(x.idxs?x.idxs.forEach((L,U)=>{Q[U]=L}):j_(x.idx)||Q.fill(x.idx),lt.idx=Q[0]),K&&lt.live){for(let L=0;L<v.length;L++)(L>0||s==1&&!le)&&K0(L,Q[L]);J0()}xt=!1,T!==!1&&Tn("setLegend")}n.setLegend=Ph;function K0(x,T){let L=v[x],U=x==0&&O==2?ri:t[x],X;le?X=L.values(n,x,T)??ne:(X=L.value(n,T==null?null:U[T],x,T),X=X==null?ne:{_:X}),lt.values[x]=X}function er(x,T,L){Qd=Ge,tf=Ye,[Ge,Ye]=ot.move(n,Ge,Ye),ot.left=Ge,ot.top=Ye,ut&&(Cr&&Yi(Cr,gn(Ge),0,B,Ct),Pr&&Yi(Pr,0,gn(Ye),B,Ct));let U,X=nn>sn;rs=ke,Ls=null;let tt=P.ori==0?B:Ct,ct=P.ori==1?B:Ct;if(Ge<0||Ke==0||X){U=ot.idx=null;for(let gt=0;gt<v.length;gt++){let Mt=he[gt];Mt!=null&&Yi(Mt,-10,-10,B,Ct)}te&&Gi(null,Nr,!0,x==null&&hn.setSeries),lt.live&&(Q.fill(U),xt=!0)}else{let gt,Mt,Dt;s==1&&(gt=P.ori==0?Ge:Ye,Mt=Hi(gt,M),U=ot.idx=Ci(Mt,t[0],nn,sn),Dt=z(t[0][U],P,tt,0));let Nt=-10,Ot=-10,oe=0,Te=0,be=!0,_e="",jt="";for(let Xt=s==2?1:0;Xt<v.length;Xt++){let We=v[Xt],Qe=Q[Xt],En=Qe==null?null:s==1?t[Xt][Qe]:t[Xt][1][Qe],Oe=ot.dataIdx(n,Xt,U,Mt),tn=Oe==null?null:s==1?t[Xt][Oe]:t[Xt][1][Oe];if(xt=xt||tn!=En||Oe!=Qe,Q[Xt]=Oe,Xt>0&&We.show){let oi=Oe==null?-10:Oe==U?Dt:z(s==1?t[0][Oe]:t[Xt][0][Oe],P,tt,0),$n=tn==null?-10:D(tn,s==1?S[We.scale]:S[We.facets[1].scale],ct,0);if(te&&tn!=null){let xi=P.ori==1?Ge:Ye,Ei=_n(kt.dist(n,Xt,Oe,$n,xi));if(Ei<rs){let Wi=kt.bias;if(Wi!=0){let ai=Hi(xi,We.scale),vi=tn>=0?1:-1,Ai=ai>=0?1:-1;Ai==vi&&(Ai==1?Wi==1?tn>=ai:tn<=ai:Wi==1?tn<=ai:tn>=ai)&&(rs=Ei,Ls=Xt)}else rs=Ei,Ls=Xt}}if(xt||Rt){let xi,Ei;P.ori==0?(xi=oi,Ei=$n):(xi=$n,Ei=oi);let Wi,ai,vi,Ai,Xi,Zn,li=!0,nr=dt.bbox;if(nr!=null){li=!1;let Jn=nr(n,Xt);vi=Jn.left,Ai=Jn.top,Wi=Jn.width,ai=Jn.height}else vi=xi,Ai=Ei,Wi=ai=dt.size(n,Xt);if(Zn=dt.fill(n,Xt),Xi=dt.stroke(n,Xt),Rt)Xt==Ls&&rs<=kt.prox&&(Nt=vi,Ot=Ai,oe=Wi,Te=ai,be=li,_e=Zn,jt=Xi);else{let Jn=he[Xt];Jn!=null&&(Ve[Xt]=vi,qn[Xt]=Ai,Zf(Jn,Wi,ai,li),Yf(Jn,Zn,Xi),Yi(Jn,Si(vi),Si(Ai),B,Ct))}}}}if(Rt){let Xt=kt.prox,We=tr==null?rs<=Xt:rs>Xt||Ls!=tr;if(xt||We){let Qe=he[0];Qe!=null&&(Ve[0]=Nt,qn[0]=Ot,Zf(Qe,oe,Te,be),Yf(Qe,_e,jt),Yi(Qe,Si(Nt),Si(Ot),B,Ct))}}}if(He.show&&Ps)if(x!=null){let[gt,Mt]=hn.scales,[Dt,Nt]=hn.match,[Ot,oe]=x.cursor.sync.scales,Te=x.cursor.drag;if(bn=Te._x,wn=Te._y,bn||wn){let{left:be,top:_e,width:jt,height:Xt}=x.select,We=x.scales[Ot].ori,Qe=x.posToVal,En,Oe,tn,oi,$n,xi=gt!=null&&Dt(gt,Ot),Ei=Mt!=null&&Nt(Mt,oe);xi&&bn?(We==0?(En=be,Oe=jt):(En=_e,Oe=Xt),tn=S[gt],oi=z(Qe(En,Ot),tn,tt,0),$n=z(Qe(En+Oe,Ot),tn,tt,0),Uo(Pi(oi,$n),_n($n-oi))):Uo(0,tt),Ei&&wn?(We==1?(En=be,Oe=jt):(En=_e,Oe=Xt),tn=S[Mt],oi=D(Qe(En,oe),tn,ct,0),$n=D(Qe(En+Oe,oe),tn,ct,0),Fo(Pi(oi,$n),_n($n-oi))):Fo(0,ct)}else Dh()}else{let gt=_n(Qd-Kd),Mt=_n(tf-jd);if(P.ori==1){let oe=gt;gt=Mt,Mt=oe}bn=In.x&&gt>=In.dist,wn=In.y&&Mt>=In.dist;let Dt=In.uni;Dt!=null?bn&&wn&&(bn=gt>=Dt,wn=Mt>=Dt,!bn&&!wn&&(Mt>gt?wn=!0:bn=!0)):In.x&&In.y&&(bn||wn)&&(bn=wn=!0);let Nt,Ot;bn&&(P.ori==0?(Nt=Ir,Ot=Ge):(Nt=Lr,Ot=Ye),Uo(Pi(Nt,Ot),_n(Ot-Nt)),wn||Fo(0,ct)),wn&&(P.ori==1?(Nt=Ir,Ot=Ge):(Nt=Lr,Ot=Ye),Fo(Pi(Nt,Ot),_n(Ot-Nt)),bn||Uo(0,tt)),!bn&&!wn&&(Uo(0,0),Fo(0,0))}if(In._x=bn,In._y=wn,x==null){if(L){if(pf!=null){let[gt,Mt]=hn.scales;hn.values[0]=gt!=null?Hi(P.ori==0?Ge:Ye,gt):null,hn.values[1]=Mt!=null?Hi(P.ori==1?Ge:Ye,Mt):null}Bo(Yh,n,Ge,Ye,B,Ct,U)}if(te){let gt=L&&hn.setSeries,Mt=kt.prox;tr==null?rs<=Mt&&Gi(Ls,Nr,!0,gt):rs>Mt?Gi(null,Nr,!0,gt):Ls!=tr&&Gi(Ls,Nr,!0,gt)}}xt&&(lt.idx=U,Ph()),T!==!1&&Tn("setCursor")}let Ds=null;Object.defineProperty(n,"rect",{get(){return Ds==null&&Oo(!1),Ds}});function Oo(x=!1){x?Ds=null:(Ds=p.getBoundingClientRect(),Tn("syncRect",Ds))}function sf(x,T,L,U,X,tt,ct){ot._lock||Ps&&x!=null&&x.movementX==0&&x.movementY==0||(Ih(x,T,L,U,X,tt,ct,!1,x!=null),x!=null?er(null,!0,!0):er(T,!0,!1))}function Ih(x,T,L,U,X,tt,ct,gt,Mt){if(Ds==null&&Oo(!1),Qt(x),x!=null)L=x.clientX-Ds.left,U=x.clientY-Ds.top;else{if(L<0||U<0){Ge=-10,Ye=-10;return}let[Dt,Nt]=hn.scales,Ot=T.cursor.sync,[oe,Te]=Ot.values,[be,_e]=Ot.scales,[jt,Xt]=hn.match,We=T.axes[0].side%2==1,Qe=P.ori==0?B:Ct,En=P.ori==1?B:Ct,Oe=We?tt:X,tn=We?X:tt,oi=We?U:L,$n=We?L:U;if(be!=null?L=jt(Dt,be)?a(oe,S[Dt],Qe,0):-10:L=Qe*(oi/Oe),_e!=null?U=Xt(Nt,_e)?a(Te,S[Nt],En,0):-10:U=En*($n/tn),P.ori==1){let xi=L;L=U,U=xi}}Mt&&(T==null||T.cursor.event.type==Yh)&&((L<=1||L>=B-1)&&(L=sr(L,B)),(U<=1||U>=Ct-1)&&(U=sr(U,Ct))),gt?(Kd=L,jd=U,[Ir,Lr]=ot.move(n,L,U)):(Ge=L,Ye=U)}let Lh={width:0,height:0,left:0,top:0};function Dh(){Ha(Lh,!1)}let rf,of,af,lf;function cf(x,T,L,U,X,tt,ct){Ps=!0,bn=wn=In._x=In._y=!1,Ih(x,T,L,U,X,tt,ct,!0,!1),x!=null&&(Se($h,Qh,hf,!1),Bo(zf,n,Ir,Lr,B,Ct,null));let{left:gt,top:Mt,width:Dt,height:Nt}=He;rf=gt,of=Mt,af=Dt,lf=Nt}function hf(x,T,L,U,X,tt,ct){Ps=In._x=In._y=!1,Ih(x,T,L,U,X,tt,ct,!1,!0);let{left:gt,top:Mt,width:Dt,height:Nt}=He,Ot=Dt>0||Nt>0,oe=rf!=gt||of!=Mt||af!=Dt||lf!=Nt;if(Ot&&oe&&Ha(He),In.setScale&&Ot&&oe){let Te=gt,be=Dt,_e=Mt,jt=Nt;if(P.ori==1&&(Te=Mt,be=Nt,_e=gt,jt=Dt),bn&&Is(M,Hi(Te,M),Hi(Te+be,M)),wn)for(let Xt in S){let We=S[Xt];Xt!=M&&We.from==null&&We.min!=ke&&Is(Xt,Hi(_e+jt,Xt),Hi(_e,Xt))}Dh()}else ot.lock&&(ot._lock=!ot._lock,er(T,!0,x!=null));x!=null&&(fn($h,Qh),Bo($h,n,Ge,Ye,B,Ct,null))}function j0(x,T,L,U,X,tt,ct){if(ot._lock)return;Qt(x);let gt=Ps;if(Ps){let Mt=!0,Dt=!0,Nt=10,Ot,oe;P.ori==0?(Ot=bn,oe=wn):(Ot=wn,oe=bn),Ot&&oe&&(Mt=Ge<=Nt||Ge>=B-Nt,Dt=Ye<=Nt||Ye>=Ct-Nt),Ot&&Mt&&(Ge=Ge<Ir?0:B),oe&&Dt&&(Ye=Ye<Lr?0:Ct),er(null,!0,!0),Ps=!1}Ge=-10,Ye=-10,Q.fill(null),er(null,!0,!0),gt&&(Ps=gt)}function uf(x,T,L,U,X,tt,ct){ot._lock||(Qt(x),No(),Dh(),x!=null&&Bo(Hf,n,Ge,Ye,B,Ct,null))}function df(){A.forEach(pv),F(n.width,n.height,!0)}ar(il,kr,df);let Ur={};Ur.mousedown=cf,Ur.mousemove=sf,Ur.mouseup=hf,Ur.dblclick=uf,Ur.setSeries=(x,T,L,U)=>{let X=hn.match[2];L=X(n,T,L),L!=-1&&Gi(L,U,!0,!1)},ut&&(Se(zf,p,cf),Se(Yh,p,sf),Se(Vf,p,x=>{Qt(x),Oo(!1)}),Se(Gf,p,j0),Se(Hf,p,uf),au.add(n),n.syncRect=Oo);let Wa=n.hooks=i.hooks||{};function Tn(x,T,L){Yn?De.push([x,T,L]):x in Wa&&Wa[x].forEach(U=>{U.call(null,n,T,L)})}(i.plugins||[]).forEach(x=>{for(let T in x.hooks)Wa[T]=(Wa[T]||[]).concat(x.hooks[T])});let ff=(x,T,L)=>L,hn=un({key:null,setSeries:!1,filters:{pub:tp,sub:tp},scales:[M,v[1]?v[1].scale:null],match:[ep,ep,ff],values:[null,null]},ot.sync);hn.match.length==2&&hn.match.push(ff),ot.sync=hn;let pf=hn.key,Nh=Kp(pf);function Bo(x,T,L,U,X,tt,ct){hn.filters.pub(x,T,L,U,X,tt,ct)&&Nh.pub(x,T,L,U,X,tt,ct)}Nh.sub(n);function Q0(x,T,L,U,X,tt,ct){hn.filters.sub(x,T,L,U,X,tt,ct)&&Ur[x](null,T,L,U,X,tt,ct)}n.pub=Q0;function t_(){Nh.unsub(n),au.delete(n),Mn.clear(),nu(il,kr,df),l.remove(),_t?.remove(),Tn("destroy")}n.destroy=t_;function Uh(){Tn("init",i,t),Do(t||i.data,!1),H[M]?Ah(M,H[M]):No(),st=He.show&&(He.width>0||He.height>0),nt=xt=!0,F(i.width,i.height)}return v.forEach(Tr),A.forEach(es),e?e instanceof HTMLElement?(e.appendChild(l),Uh()):e(n,Uh):Uh(),n}Rn.assign=un;Rn.fmtNum=pu;Rn.rangeNum=sl;Rn.rangeLog=al;Rn.rangeAsinh=du;Rn.orient=cr;Rn.pxRatio=Ee;Rn.join=rx;Rn.fmtDate=gu,Rn.tzDate=gx;Rn.sync=Kp;{Rn.addGap=jx,Rn.clipGaps=hl;let i=Rn.paths={points:im};i.linear=rm,i.stepped=ev,i.bars=nv,i.spline=sv}var mv=[[],[8,4],[2,3]];function cm(i,t,e){return{label:i,labelSize:18,labelFont:"12px system-ui, sans-serif",font:"12px system-ui, sans-serif",stroke:t,grid:{stroke:e,width:1},ticks:{stroke:e,width:1},values:(n,s)=>s.map(On)}}var Ii=class{constructor({x:t,y:e,series:n,alt:s,height:r=190}){this.options={x:t,y:e,series:n,height:r},this.element=Y("div",{class:"plot",role:"img","aria-label":s}),this.data=[[],...n.map(()=>[])],this.plot=null,new ResizeObserver(()=>this.resize()).observe(this.element),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.restyle()),document.addEventListener("themechange",()=>this.restyle())}make(){let{x:t,y:e,series:n,height:s}=this.options,[r,o]=[Fn("ink"),Fn("line")],a=[1,2,3].map(c=>Fn(`series-${c}`));this.plot=new Rn({width:Math.max(120,this.element.clientWidth),height:s,legend:{show:n.length>1,live:!1},cursor:{show:!1},scales:{x:{time:!1,range:(c,l,h)=>this.reach(l,h)}},axes:[cm(t,r,o),{...cm(e,r,o),size:56}],series:[{},...n.map(({label:c,kind:l="line"},h)=>({label:c,stroke:a[h%3],width:2,dash:mv[h%3],points:{show:!1},spanGaps:!1,...l==="bars"?{paths:Rn.paths.bars({size:[.9,60]}),fill:a[h%3],dash:[],width:0}:{}}))]},this.data,this.element)}reach(t,e){let[n]=this.data,r=this.options.series.some(({kind:o})=>o==="bars")&&n.length>1?(n[1]-n[0])/2:0;return e>t?[t-r,e+r]:[t-1,e+1]}resize(){this.element.clientWidth!==0&&(this.plot?this.plot.setSize({width:Math.max(120,this.element.clientWidth),height:this.options.height}):this.make())}restyle(){this.plot?.destroy(),this.plot=null,this.resize()}show(t){this.data=t,this.plot?.setData(t)}};function Yr(i,t){let e=null,n=Y("input",{type:"number",min:0,step:1,"aria-label":"Shot number",onchange:()=>l(Number(n.value))}),s=Y("button",{type:"button",onclick:()=>e===null?l(i.latestResult):h()},"Hold"),r=Y("button",{type:"button","aria-label":"Shot before",onclick:()=>l(Math.max(0,(e??i.latestResult??0)-1))},"‹"),o=Y("button",{type:"button","aria-label":"Shot after",onclick:()=>l((e??i.latestResult??0)+1)},"›"),a=Y("span",{class:"hint"}),c=Y("div",{class:"choice shot-choice"},Y("span",{class:"label"},"Shot"),r,n,o,s,a);function l(u){u===null||!Number.isInteger(u)||u<0||(e=u,t(u),d())}function h(){e=null,t(null),d()}function d(){let u=e??i.latestResult;document.activeElement!==n&&(n.value=u??""),$t(s,e===null?"Hold":"Follow"),s.setAttribute("aria-pressed",String(e!==null)),$t(a,e===null?"the latest":"held")}return{element:c,update:d,get held(){return e}}}var gv=40,pl=class{constructor(t,{changed:e=()=>{},overlay:n=null}={}){this.canvas=Y("canvas",{class:"zoom",tabindex:"0",role:"img","aria-label":`${t}; plus and minus magnify, arrow keys move`}),this.changed=e,this.overlay=n,this.bitmap=null,this.size=[1,1],this.zoom=1,this.brightness=1,this.middle=[.5,.5],this.pointers=new Map,this.canvas.addEventListener("wheel",s=>{s.preventDefault(),this.magnify(Math.exp(-s.deltaY/300),this.under(s))},{passive:!1}),this.canvas.addEventListener("pointerdown",s=>{this.canvas.setPointerCapture(s.pointerId),this.pointers.set(s.pointerId,[s.clientX,s.clientY])}),this.canvas.addEventListener("pointermove",s=>this.drag(s));for(let s of["pointerup","pointercancel"])this.canvas.addEventListener(s,r=>this.pointers.delete(r.pointerId));this.canvas.addEventListener("dblclick",s=>this.magnify(2,this.under(s))),this.canvas.addEventListener("keydown",s=>this.key(s)),new ResizeObserver(()=>this.draw()).observe(this.canvas)}key(t){let e=.15/this.zoom,n={ArrowLeft:[-e,0],ArrowRight:[e,0],ArrowUp:[0,-e],ArrowDown:[0,e]},s={"+":1.4,"=":1.4,"-":1/1.4,0:1/this.zoom};if(n[t.key])this.move(...n[t.key]);else if(s[t.key])this.magnify(s[t.key],this.middle);else return;t.preventDefault()}drag(t){let e=this.pointers.get(t.pointerId);if(!e)return;let n=[t.clientX,t.clientY],s=[...this.pointers].filter(([o])=>o!==t.pointerId).map(([,o])=>o);if(this.pointers.set(t.pointerId,n),s.length===1){let o=a=>Math.hypot(a[0]-s[0][0],a[1]-s[0][1]);this.magnify(o(n)/Math.max(1,o(e)),this.middle);return}let r=this.scale();this.move(-(n[0]-e[0])/(r*this.size[0]),-(n[1]-e[1])/(r*this.size[1]))}move(t,e){this.middle=[this.middle[0]+t,this.middle[1]+e],this.settle()}magnify(t,e){let n=Math.min(gv,Math.max(1,this.zoom*t)),s=this.zoom/n;this.middle=this.middle.map((r,o)=>e[o]+(r-e[o])*s),this.zoom=n,this.settle()}settle(){this.middle=this.middle.map(t=>Math.min(1-.5/this.zoom,Math.max(.5/this.zoom,t))),this.draw(),this.changed()}scale(){let{clientWidth:t,clientHeight:e}=this.canvas;return this.zoom*Math.min(t/this.size[0],e/this.size[1])}under(t){let e=this.canvas.getBoundingClientRect(),n=this.scale();return[this.middle[0]+(t.clientX-e.left-e.width/2)/(n*this.size[0]),this.middle[1]+(t.clientY-e.top-e.height/2)/(n*this.size[1])]}show(t,e){this.bitmap?.close(),this.bitmap=t,this.size=e,this.draw()}draw(){let{width:t,height:e,ratio:n}=Us(this.canvas),s=this.canvas.getContext("2d");if(s.setTransform(1,0,0,1,0,0),s.fillStyle=Fn("image-ground"),s.fillRect(0,0,t,e),!this.bitmap)return;let r=this.scale()*n,[o,a]=[t/2-this.middle[0]*this.size[0]*r,e/2-this.middle[1]*this.size[1]*r],c=r*this.size[0]/this.bitmap.width;s.imageSmoothingEnabled=c<3*n,s.filter=this.brightness===1?"none":`brightness(${this.brightness})`,s.drawImage(this.bitmap,o,a,this.size[0]*r,this.size[1]*r),s.filter="none";let l=(h,d)=>[o+(h+.5)*r,a+(d+.5)*r];this.overlay?.(s,{place:l,scale:r,ratio:n,width:t,height:e})}};var _v=2e3,[xv,vv]=[900,8192],yv=2.5,hm=1.25,Sv=.15,Mv=.9,bv=5;function um(i){let t=Y("div",{class:"view cameras-view"}),e={frame:"a",held:null},n=Yr(i,f=>{e.held=f,u(!0)}),s=as("Frame",{a:"a",b:"b"},f=>{e.frame=f,u(!0)}),r=Ns("Configured micro-images",!0,()=>c.forEach(f=>f.draw())),o=zo("Brightness",{max:4,value:0},f=>{$t(o.shown,`× ${2**f}`),c.forEach(p=>p.brighten(2**f))});$t(o.shown,"× 1");let a=Y("div",{class:"two"}),c=[];t.append(Y("div",{class:"controls"},n.element,s.element,o.element,r.element),a);let l=-1/0,h=!1;function d(){return i.status?.configuration.cameras??[]}async function u(f=!1){if(!(t.hidden||!t.isConnected||h||document.hidden)){for(;c.length<d().length;)c.push(wv(d()[c.length],c.length+1,i,e,r.input)),a.append(c.at(-1).element);!f&&(performance.now()-l<_v||e.held!==null)||(l=performance.now(),h=!0,await Promise.all(c.map(p=>p.load())),h=!1)}}return{element:t,update(){n.update(),u()},show:()=>u(!0)}}function wv(i,t,e,n,s){let r=()=>c.zoom>yv,o={shot:null,frame:null,near:!1},a=null,c=new pl(`Image of ${i}`,{changed:()=>r()!==o.near&&y(),overlay:(g,v)=>s.checked&&a&&Ev(g,v,a)}),l=Y("p",{class:"empty"}),h=Y("canvas",{class:"micro-image",role:"img","aria-label":"Mean micro-image"}),d={light:Wt("Light a, b",{title:"mean light above black, in counts"}),ratio:Wt("Light a over b"),saturated:Wt("Saturated a, b"),bright:Wt("Lit by particles",{title:"share of the pixels that hold a particle's light"}),seeding:Wt("Seeding a, b",{title:"particles per microlens of the volume"}),black:Wt("Black, noise"),diameter:Wt("Micro-images fill"),fNumber:Wt("f-number",{title:"of the main lens, as the micro-images show it"}),edge:Wt("Edge",{title:"distance over which light falls from 80 % to 20 %"})},u=Y("ul",{class:"causes"}),f=new Ii({x:"counts",y:"log10 pixels",height:150,alt:`Histogram of ${i}`,series:[{label:"frame a"},{label:"frame b"}]}),p=en(i,l,c.canvas,Y("dl",{class:"readings"},...Object.values(d).map(g=>g.element)),Y("div",{class:"beside"},Y("figure",{},h,Y("figcaption",{},"Mean micro-image")),Y("div",{},u)),f.element);async function y(){let g=`/api/v1/shots/${n.held??"latest"}/frames/${t}`,v=r()?vv:xv;try{let[{bitmap:A},S]=await Promise.all([qa(`${g}/${n.frame}.png?width=${v}`),os(`${g}/statistics`)]);o={shot:S.shot,frame:n.frame,near:r()},a=S.configured;let[C,M]=a.sensor_px;c.show(A,[C,M]),$t(l,""),m(S)}catch(A){$t(l,A instanceof mn?A.message:"the daemon does not answer")}}function m(g){let[v,A]=g.frames,S=D=>`${D(v)}, ${D(A)}`;d.light.show(S(D=>qt(D.light_counts)));let C=g.a_over_b,M=C!==null&&(C>hm||C<1/hm);d.ratio.show(qt(C,2),M?"doubt":null);let _=Math.max(v.saturated_share,A.saturated_share);d.saturated.show(S(D=>An(D.saturated_share,2)),_>.001?"doubt":null),d.bright.show(S(D=>An(D.bright_share))),d.seeding.show(S(D=>qt(D.seeding_ppm,2))),d.black.show(`${qt(v.offset_counts)}, ${qt(v.noise_counts,2)}`);let b=v.micro_image;d.diameter.show(b?An(b.diameter_pitches):"–"),d.fNumber.show(b?`f/${qt(b.f_number,2)} (configured f/${qt(a.f_number,2)})`:"–"),d.edge.show(b?.edge_px?`${qt(b.edge_px,2)} px`:"–");let N=Tv(g,{unequal:M,saturated:_});u.replaceChildren(...N.map(([D,H])=>Y("li",{"data-tone":D},H))),Av(h,b);let R=Math.max(v.histogram.length,A.histogram.length),P=Math.max(v.bin_counts,A.bin_counts),O=Array.from({length:R},(D,H)=>(H+.5)*P),z=D=>{let H=new Array(R).fill(0);return D.histogram.forEach((W,V)=>{H[Math.min(R-1,Math.floor((V+.5)*D.bin_counts/P))]+=W}),H.map(W=>W>0?Math.log10(W):null)};f.show([O,z(v),z(A)])}return{element:p,load:y,draw:()=>c.draw(),brighten(g){c.brightness=g,c.draw()}}}function Tv({configured:i,frames:t,a_over_b:e},{unequal:n,saturated:s}){let r=[];n&&r.push(["doubt",`Frame a has ${qt(e,2)} times the light of frame b: set the laser heads alike.`]),s>.001&&r.push(["doubt",`${An(s,1)} of the pixels are saturated: less laser light, or a lower gain.`]);let o=t[0].micro_image;if(!o)return r.push(["doubt","Micro-images do not stand out: too little light, main lens opened too far, or the array is out of focus."]),r;let a=o.diameter_pitches&&o.diameter_pitches/(i.diameter_px/i.pitch_px);return o.corner_share>Sv||a===null?r.push(["doubt",`Micro-images overlap: their corners have ${An(o.corner_share)} of the light. Stop the main lens down towards f/${qt(i.f_number,2)}.`]):a<Mv?r.push(["doubt",`Micro-images fill only ${An(a)} of their diameter: open the main lens from f/${qt(o.f_number,2)} to f/${qt(i.f_number,2)}.`]):r.push(["good","Micro-images fill their pitch and do not overlap: the f-numbers match."]),o.edge_px!==null&&r.push(o.edge_px>bv?["doubt",`Their edges are ${qt(o.edge_px,2)} px wide: move the sensor into the microlenses' focal plane.`]:["good",`Their edges are ${qt(o.edge_px,2)} px wide: the array is in focus.`]),r}function Ev(i,{place:t,scale:e,ratio:n,width:s,height:r},{pitch_px:o,diameter_px:a,middle_px:c}){if(o*e<14*n)return;let[l,h]=t(...c),d=o*e;i.strokeStyle="#ffb000",i.lineWidth=1.2*n,i.beginPath();for(let u=l%d-d;u<s+d;u+=d)for(let f=h%d-d;f<r+d;f+=d)i.moveTo(u+a*e/2,f),i.arc(u,f,a*e/2,0,2*Math.PI);i.stroke()}function Av(i,t){let e=t?.cells??1;[i.width,i.height]=[e,e];let n=i.getContext("2d"),s=n.createImageData(e,e),r=Math.max(1,...t?.light??[]);for(let o=0;o<e*e;o+=1){let a=Math.max(0,Math.round(255*(t?.light[o]??0)/r));s.data.set([a,a,a,255],4*o)}n.putImageData(s,0,0)}function Bs(i){let t=Y("thead"),e=Y("tbody"),n=Y("caption",{},i),s=Y("div",{class:"table",tabindex:"0",role:"region","aria-label":i},Y("table",{},n,t,e));function r(o,a,c,l){let h=o.children[a]??o.appendChild(Y("tr"));for(;h.childElementCount<l.length;)h.append(Y(c,c==="th"?{scope:"col"}:{}));for(;h.childElementCount>l.length;)h.lastChild.remove();l.forEach((d,u)=>{$t(h.children[u],d.text??d),Un(h.children[u],"data-tone",d.tone??null)})}return{element:s,show(o,a,c=""){for(r(t,0,"th",o),a.forEach((l,h)=>r(e,h,"td",l));e.childElementCount>a.length;)e.lastChild.remove();$t(n,c||i)}}}var dm={measuring:"good",idle:null,lost:"bad",ended:null},bu=40,Rv=2;function fm(i){let t={backlog:Wt("To be measured"),inHand:Wt("Being measured"),waiting:Wt("Waiting"),rate:Wt("All workers",{title:"results over the last minute"}),left:Wt("Work left",{title:"shots to be measured, over the present rate"}),begun:Wt("Begun",{title:"measurements that workers have begun"}),notEnded:Wt("Not ended",{title:"measurements whose worker was lost: their shots went to others"}),givenUp:Wt("Given up",{title:"after three failures or ten lost workers"}),refused:Wt("Results refused",{title:"damaged, or not of this run"})},e=Y("p",{class:"advice"}),n=Bs("Workers"),s=Y("p",{class:"hint"}),r=Bs("Shots that were given up"),o=new Ii({x:"minutes from now",y:"shots",height:150,alt:"Shots to be measured and being measured, over the last minutes",series:[{label:"to be measured"},{label:"being measured"}]}),a=en("Workers",Y("dl",{class:"readings"},...Object.values(t).map(l=>l.element)),e,Y("div",{class:"two"},Y("div",{},n.element,s,r.element),Y("div",{},o.element)));return a.classList.add("workers"),a.hidden=!0,{element:a,show(l){if(a.hidden=!l,!l)return;let{shots:h,workers:d}=l;t.backlog.show(Me(h.backlog)),t.inHand.show(Me(h.in_hand)),t.waiting.show(Me(Math.max(0,h.backlog-h.in_hand))),t.rate.show(`${qt(60*l.shots_per_s)} shots/min`),t.left.show(h.backlog===0?"none":l.shots_per_s>0?ls(h.backlog/l.shots_per_s):"–"),t.begun.show(Me(h.attempts)),t.notEnded.show(Me(h.lost_workers),h.lost_workers>0?"doubt":null),t.givenUp.show(Me(h.given_up),h.given_up>0?"bad":null),t.refused.show(Me(h.refused_results),h.refused_results>0?"bad":null);let[u,f]=Cv(l);$t(e,f),Un(e,"data-tone",u),c(d),r.element.hidden=l.given_up.length===0,r.show(["Shot","why"],l.given_up.map(({shot:y,reasons:m})=>[String(y),m.join("; ")]),l.given_up.length<h.given_up?`The first ${l.given_up.length} of ${Me(h.given_up)} shots that were given up`:"");let p=i.backlog.at(-1)?.at??0;o.show([i.backlog.map(({at:y})=>(y-p)/6e4),i.backlog.map(y=>y.backlog),i.backlog.map(y=>y.inHand)])}};function c(l){let h=Object.keys(dm),d=[...l].sort((u,f)=>h.indexOf(u.state)-h.indexOf(f.state));n.element.hidden=l.length===0,n.show(["Worker","state","delivered","shots/min","in hand","begun","failed","not ended","last heard of"],d.slice(0,bu).map(u=>[u.worker,{text:u.state,tone:dm[u.state]},Me(u.shots),qt(60*u.shots_per_s),Me(u.in_hand),Me(u.attempts),{text:Me(u.failures),tone:u.failures>0?"doubt":null},{text:Me(u.not_ended),tone:u.not_ended>0?"doubt":null},u.silent_s<Rv?"now":`${ls(u.silent_s)} ago`])),s.hidden=l.length<=bu,$t(s,`and ${Me(l.length-bu)} more: GET /api/v1/status lists all of them`)}}function Cv({broker:i,connected:t,heartbeat_timeout_s:e,shots:n,workers:s}){if(!t)return["doubt",`The broker at ${i} does not answer. Shots are recorded, and wait until it does.`];let r=(...l)=>s.filter(({state:h})=>l.includes(h)).length,o=r("measuring","idle");if(o===0&&n.backlog>0)return["doubt",s.length===0?`No worker has taken a shot yet. On each machine that is to measure: lfpiv work --url ${i}`:"No worker is left: all are lost or have ended. Shots are recorded, and wait for others."];let a=r("lost"),c=a>0?` ${Me(a)} ${a===1?"was":"were"} not heard of for more than ${ls(e)}: what ${a===1?"it":"they"} had in hand goes to others.`:"";return[null,`${Me(r("measuring"))} of ${Me(o)} workers measure. The broker at ${i} answers.${c}`]}var Pv=["complete","missing_packets","underrun","missed_trigger","late","unpaired","shed","write_failed","not_fired"],pm=["acquired","paired","written","fsynced","processed"],Iv=14,mm=60,Lv=200;function gm(i){let t={run:Wt("Run"),stage:Wt("Now",{wide:!0}),dt:Wt("dt"),rate:Wt("Measured"),asked:Wt("Asked for"),queue:Wt("Queue"),latency:Wt("Latency",{title:"from trigger to stored velocity: median, 95th percentile"}),disk:Wt("Disk left"),uptime:Wt("Up for")},e={verdict:Wt("Model fit"),unexplained:Wt("Light unexplained",{title:"per camera; 0: everything is explained"}),offset:Wt("Micro-images off",{title:"largest distance from the configured place, per camera"}),disparity:Wt("Cameras apart",{title:"root mean square distance between the places at which they put particles"}),calibration:Wt("Calibration"),seeding:Wt("Seeding")},n=Y("ul",{class:"causes"}),s=Bs("Calibrated cameras: the file and its SHA-256");s.element.classList.add("hashes");let r=Bs("Triggers by camera and outcome"),o=Bs("How many shots have got how far"),a=Bs("Latest shots, newest first"),c=Y("p",{class:"hint"}),l=Y("p",{class:"hint"},"Nothing yet that is worth a line."),h=Y("ol",{class:"log"}),d=fm(i),u=new Ii({x:"shot",y:"seconds",alt:"Time that the last shots took to measure",height:150,series:[{label:"time to measure"}]}),f=Y("div",{class:"view overview"},Y("dl",{class:"readings"},...Object.values(t).map(M=>M.element)),d.element,Y("div",{class:"two"},Y("div",{},en("Shots",c,a.element),en("Model fit",Y("dl",{class:"readings"},...Object.values(e).map(M=>M.element)),n,s.element)),Y("div",{},en("What happened",l,h),en("Ledger",r.element,o.element),en("Time to measure a shot",u.element))));function p(){let{status:M}=i,_=i.brief??M;if(!_)return;let b=_.state;if(t.run.show(Ef(b),{failed:"bad",bench_lost:"bad"}[b]??null),t.stage.show(_.error??_.stage,_.error?"bad":null),t.rate.show(`${qt(i.rate,2)} shots/s`),A(_.shots),C(),!M)return;let{configuration:N,latency:R,disk:P}=M;t.dt.show(`${qt(i.control?.dt_us??N.dt_us)} µs`),t.asked.show(`${qt(N.rate_hz)} Hz${N.shots?`, ${Me(N.shots)} shots`:""}`),t.queue.element.hidden=!!M.cluster,t.queue.show(`${_.shots.queued} of ${N.queue}`,_.shots.queued>=N.queue?"doubt":null),t.latency.show(R?`${ls(R.p50_s)}, ${ls(R.p95_s)}`:"–"),y(P),t.uptime.show(ls(M.uptime_s)),d.show(M.cluster),m(M),v(M)}function y(M){if(!M){t.disk.show("–");return}let _=M.shots_left;t.disk.show(`${wf(M.free_bytes)}${_===null?"":`, ${Me(_)} shots`}`,_!==null&&_<600?"doubt":null)}function m(M){let _=M.model_fit,b=P=>_?.cameras.map(P).join(", ")??"–";e.verdict.show(_?.verdict??"–",{good:"good",doubtful:"doubt",poor:"bad"}[_?.verdict]??null),e.unexplained.show(b(P=>An(P.unexplained))),e.offset.show(_?`${b(P=>qt(P.micro_image_offset_px,2))} px`:"–"),e.disparity.show(_?.camera_disparity_mm?`${qt(_.camera_disparity_mm,2)} mm`:"–"),g(M.configuration);let N=M.model_choice?.scene;e.seeding.element.hidden=!N,e.seeding.show(N?`${qt(N.seeding_ppm,2)} per microlens`:"–");let R=_?.causes??[];(n.childElementCount!==R.length||[...n.children].some((P,O)=>P.textContent!==R[O]))&&n.replaceChildren(...R.map(P=>Y("li",{},P)))}function g({cameras:M,calibrations:_}){e.calibration.show(_.length===0?"as configured":`${_.length} of ${M.length} cameras`),s.element.hidden=_.length===0,s.show(["Camera","file","SHA-256"],_.map(({camera:b,file:N,sha256:R})=>[b,N,R]))}function v(M){let{cameras:_,balanced:b}=M.ledger,N=Pv.filter((P,O)=>O===0||_.some(z=>z.outcomes[P]>0));r.show(["Camera","triggers","open",...N.map(kh)],_.map(P=>[P.camera,Me(P.triggers),Me(P.open),...N.map(O=>Me(P.outcomes[O]))]),b?"":"The ledger does not balance.");let R=i.brief?.watermarks??M.watermarks;o.show(R?pm:["Raw data"],[R?pm.map(P=>Me(R[P])):["not kept"]])}function A(M){let _=R=>["awaiting_frames","queued"].includes(R.state),b=i.latestShots(Lv).filter(R=>!_(R)).slice(0,Iv);$t(c,`${Me(M.triggered)} triggered, ${Me(M.done)} measured; ${Me(M.awaiting_frames)} wait for frames, ${Me(M.queued)} for a worker`),a.show(["Shot","time","state","model fit","valid","took"],b.map(R=>[String(R.shot),Tf(R.time?.utc),Dv(R),R.model_fit?.verdict??"–",An(R.valid_share),R.seconds?ls(Object.values(R.seconds).reduce((P,O)=>P+O,0)):"–"]));let N=i.latestShots(120).filter(R=>R.seconds).reverse();u.show([N.map(R=>R.shot),N.map(R=>Object.values(R.seconds).reduce((P,O)=>P+O,0))])}let S=null;function C(){l.hidden=i.log.length>0;let M=i.log.at(-1)??null;if(M===S&&h.childElementCount===Math.min(mm,i.log.length))return;S=M;let _=i.log.slice(-mm).reverse();for(;h.childElementCount<_.length;)h.append(Y("li",{},Y("time",{}),Y("span",{})));for(;h.childElementCount>_.length;)h.lastChild.remove();_.forEach((b,N)=>{let R=h.children[N];$t(R.firstChild,b.at?b.at.toLocaleTimeString("en-GB"):"before"),$t(R.lastChild,b.text),Un(R,"data-tone",b.tone)})}return{element:f,update:p,show:p}}function Dv(i){let t=(i.cameras??[]).filter(n=>n.outcome&&n.outcome!=="complete"),e=i.message??i.suspect?.[0]??(i.state==="lost"?t.map(n=>`${n.camera} ${kh(n.outcome)}`).join(", "):null);return e?`${Vo(i.state)}: ${e}`:Vo(i.state)}var Nv="http://www.w3.org/2000/svg",[Zo,ml,wu,Tu]=[120,860,34,10];function ks(i,t,...e){let n=document.createElementNS(Nv,i);for(let[s,r]of Object.entries(t))n.setAttribute(s,String(r));return n.append(...e),n}function _m(){let i=Y("div",{class:"timing"}),t=null;function e(){if(!t)return;let n=p=>[p,p+t.pulse_width_us,On(p)],s=[["Lamps 1, 2",t.lamp_us.map(n),"lamp-pulse"],["Q-switches 1, 2",t.q_switch_us.map(n),"light-pulse"],["Camera trigger",[n(t.camera_trigger_us)],"trigger-pulse"],["Exposures a, b",[[...t.exposure_1_us,"a"],[...t.exposure_2_us,"b"]],"exposure"]],r=Math.max(...t.q_switch_us,...t.lamp_us)+2*t.pulse_width_us+40,o=Math.max(r,t.exposure_2_us[0]+.3*(t.exposure_1_us[1]-t.exposure_1_us[0])),a=p=>Zo+ml*Math.min(p,o)/o,c=Tu+wu*s.length+46,l=ks("svg",{viewBox:`0 0 ${Zo+ml+16} ${c}`,role:"img","aria-label":Uv(t)});s.forEach(([p,y,m],g)=>{let v=Tu+wu*(g+1)-6;l.append(ks("text",{x:0,y:v-6,class:"name"},p)),l.append(ks("line",{x1:Zo,x2:Zo+ml,y1:v,y2:v,class:"base"}));for(let[A,S,C]of y){let M=Math.max(2.5,a(S)-a(A));l.append(ks("rect",{x:a(A),y:v-20,width:M,height:20,class:m}));let _=m==="exposure"?a(A)+8:a(A)+M+4;l.append(ks("text",{x:_,y:v-6,class:"at"},C))}});let h=Tu+wu*s.length+8,d=Fv(o);for(let p=0;p<=o;p+=d)l.append(ks("line",{x1:a(p),x2:a(p),y1:h,y2:h+5,class:"base"})),l.append(ks("text",{x:a(p),y:h+20,class:"tick"},On(p)));l.append(ks("text",{x:Zo+ml/2,y:h+36,class:"tick"},"µs after T0"));let[u,f]=t.q_switch_us;i.replaceChildren(l,Y("p",{class:"hint"},`Light pulses at ${On(u)} and ${On(f)} µs, ${On(t.dt_us)} µs apart; cameras ready again after ${qt(t.camera_ready_us/1e3)} ms of a period of ${qt(t.period_us/1e3)} ms.`))}return{element:i,draw:e,show(n){t=n,e()}}}function Uv({q_switch_us:[i,t],exposure_1_us:e,exposure_2_us:n}){return`Timing diagram: light pulse 1 at ${qt(i,4)} µs in exposure a from ${qt(e[0],4)} to ${qt(e[1],4)} µs; light pulse 2 at ${qt(t,4)} µs in exposure b from ${qt(n[0],4)} µs`}function Fv(i){let t=10**Math.floor(Math.log10(i/8));return[1,2,5,10].map(e=>e*t).find(e=>e>=i/8)}var Ov=4096;function vm(i,t){let e=Wt("Laser",{wide:!0}),n=Wt("Why nothing is fired",{wide:!0}),s={configuration:Wt("Configuration allows arming",{title:"server.remote_arming"}),operator:Wt("Operator has enabled it at the bench",{title:"lfpiv run --remote-arming"})},r=Y("button",{type:"button",onclick:()=>l.showModal()},"Arm …"),o=Y("button",{type:"button",onclick:()=>t.send("start")},"Start"),a=Y("input",{type:"checkbox",id:"goggles",onchange:()=>{c.disabled=!a.checked}}),c=Y("button",{type:"submit",class:"primary",disabled:!0},"Arm the laser"),l=Y("dialog",{"aria-labelledby":"arm-title"},Y("form",{onsubmit:W=>M(W)},Y("h2",{id:"arm-title"},"Arm the laser?"),Y("p",{},"The lamps begin to fire. After start, light pulses leave the laser. This page is no interlock."),Y("div",{class:"choice"},a,Y("label",{for:"goggles"},"The room is clear and everybody in it wears goggles")),Y("div",{class:"row"},c,Y("button",{type:"button",onclick:()=>l.close()},"Cancel"))));l.addEventListener("close",()=>{a.checked=!1,c.disabled=!0});let h=Y("p",{class:"hint"}),d=Y("input",{type:"number",id:"dt",min:.1,max:1e6,step:"any",oninput:()=>P()}),u=Y("button",{type:"submit"},"Set dt"),f=Y("form",{class:"controls",onsubmit:W=>_(W)},Y("label",{for:"dt"},"Time between the pulses (µs)"),d,u),p=_m(),y=Y("p",{class:"advice","data-tone":"doubt"}),m=Y("textarea",{id:"note",rows:3,maxlength:Ov}),g=Y("form",{onsubmit:W=>b(W)},Y("label",{for:"note"},"Words for the run's record"),m,Y("div",{class:"row"},Y("button",{type:"submit"},"Add the note"))),v=Y("ol",{class:"log"}),A=Y("p",{class:"hint"}),S=Y("pre",{class:"settings",tabindex:"0",role:"region","aria-label":"Configuration"}),C=Y("div",{class:"view run"},Y("div",{class:"two"},en("Controls",Y("dl",{class:"readings"},e.element,n.element,...Object.values(s).map(W=>W.element)),Y("div",{class:"controls large"},r,o),h),en("Notes",g,v)),en("Timing",f,y,p.element),en("Settings",A,S),l);async function M(W){W.preventDefault(),a.checked&&(l.close(),await t.send("arm"))}async function _(W){W.preventDefault(),await t.send("dt",{dt_us:Number(d.value)})&&(N=!1)}async function b(W){W.preventDefault(),m.value.trim()&&await t.send("note",{text:m.value.trim()})&&(m.value="")}let N=!1,R=null;function P(){N=!0,O(Number(d.value))}async function O(W){if(!(!(W>0)||R===W)){R=W;try{let V=await os(`/api/v1/control/timing?dt_us=${encodeURIComponent(W)}`);if(R!==W)return;$t(y,""),p.show(V)}catch(V){if(R!==W)return;$t(y,V instanceof mn?V.message:"the daemon does not answer"),V instanceof mn||(R=null)}}}let z=null;async function D(){if(!(z===i.run&&S.textContent))try{let{file:W,text:V}=await os("/api/v1/configuration");z=i.run,$t(A,W),$t(S,V)}catch(W){$t(A,W instanceof mn?W.message:"the daemon does not answer")}}function H(){let W=Za(i);e.show(`${W.word} (${W.detail})`,W.tone==="firing"||W.tone==="unknown"?"bad":null),n.show(i.control?.held?.join("; ")||"–",i.control?.held?.length?"doubt":null);let V=i.permissions;s.configuration.show(V?xm(V.allowed_by_configuration):"–"),s.operator.show(V?xm(V.enabled_at_bench):"–");let ht=!!V?.controllable;r.disabled=o.disabled=!V?.may_arm||i.stale,u.disabled=d.disabled=!ht,g.hidden=!ht,$t(h,ht?V.may_arm?"Arm warms the lamps, start takes shots. Both need a token of scope control; stop and disarm are on top of every view.":"Arming over HTTP needs both permissions. Stop and disarm need a token of scope control only.":"A recorded run cannot be controlled.");let J=i.control?.dt_us??i.status?.configuration.dt_us;!N&&J&&document.activeElement!==d&&(d.value=String(J),O(J));let k=i.log.filter(Q=>Q.tone==="note").slice(-30).reverse();for(;v.childElementCount<k.length;)v.append(Y("li",{},Y("time",{}),Y("span",{})));for(;v.childElementCount>k.length;)v.lastChild.remove();k.forEach((Q,lt)=>{$t(v.children[lt].firstChild,Q.at?Q.at.toLocaleTimeString("en-GB"):"before"),$t(v.children[lt].lastChild,Q.text.replace(/^Note: /,"")),Un(v.children[lt],"data-tone","note")}),C.hidden||D()}return{element:C,update:H,show(){H(),p.draw()}}}var xm=i=>i?"yes":"no";function Jo(){let i=Y("canvas",{class:"colours","aria-hidden":"true"}),[t,e,n]=[Y("span"),Y("span"),Y("span")],s=Y("span",{class:"title"}),r=Y("div",{class:"colour-bar"},s,i,Y("div",{class:"ends"},t,e,n)),o=null;return{element:r,show(a,c){$t(s,c),$t(t,qt(a.low)),$t(e,qt((a.low+a.high)/2)),$t(n,qt(a.high)),o!==a.colours&&a.paint(i),o=a.colours}}}var Bv=["#00224e","#123570","#3b496c","#575d6d","#707173","#8a8678","#a59c74","#c3b369","#e1cc55","#fee838"],kv=["#9c179e","#bd3786","#d8576b","#ed7953","#fb9f3a","#fdca26","#f0f921"],zv=["#001261","#033e7d","#1e6f9d","#71a8c4","#c9dde7","#eacebd","#d39774","#be6533","#8b2706","#590007"],Vv=i=>[1,3,5].map(t=>parseInt(i.slice(t,t+2),16));function Eu(i){let t=new Uint8Array(768),e=i.map(Vv);for(let n=0;n<256;n+=1){let s=n/255*(e.length-1),r=Math.min(e.length-2,Math.floor(s));for(let o=0;o<3;o+=1)t[3*n+o]=Math.round(e[r][o]+(s-r)*(e[r+1][o]-e[r][o]))}return t}var Gv=Eu(Bv),Hv=Eu(zv),ym=Eu(kv),hr=class{constructor(t,e,n=!1,s=n?Hv:Gv){this.low=t,this.high=e>t?e:t+1e-9,this.signed=n,this.colours=s}rgb(t){let e=Math.min(1,Math.max(0,(t-this.low)/(this.high-this.low))),n=3*Math.round(255*e);return[this.colours[n],this.colours[n+1],this.colours[n+2]]}paint(t){t.width=256,t.height=1;let e=t.getContext("2d"),n=e.createImageData(256,1);for(let s=0;s<256;s+=1)n.data.set([this.colours[3*s],this.colours[3*s+1],this.colours[3*s+2],255],4*s);e.putImageData(n,0,0)}};var Wv=.35,Xv=300,Sm=.2,qv=.25;function gl(i,t){let e=[];for(let n=0;n<i.status.length;n+=1)i.status[n]===0&&e.push(i.displacement[3*n+t]);return e}function Mm(i,t){let[e,n]=[1/0,-1/0];for(let o of i)e=Math.min(e,o),n=Math.max(n,o);n>e||([e,n]=Number.isFinite(e)?[e-.5,e+.5]:[0,1]);let s=(n-e)/t,r=new Array(t).fill(0);for(let o of i)r[Math.min(t-1,Math.floor((o-e)/s))]+=1;return{centres:r.map((o,a)=>e+(a+.5)*s),counts:r,width:s}}function Yv(i){if(i.length<Xv)return null;let t=i.reduce((o,a)=>o+a,0)/i.length,e=i.reduce((o,a)=>o+(a-t)**2,0)/i.length;if(Math.sqrt(e)<Wv)return null;let[n,s]=[0,0];for(let o of i)n+=Math.cos(2*Math.PI*o),s+=Math.sin(2*Math.PI*o);let r=Math.exp(-2*Math.PI**2*e);return Math.max(0,Math.hypot(n,s)/i.length-r)}function bm(i){let e=["x","y","z"].map((r,o)=>[r,Yv(gl(i,o))]).filter(([,r])=>r!==null);if(e.length===0)return{text:"Peak locking cannot be judged: too few vectors, or displacements spread over less than a voxel.",tone:null};let n=e.filter(([,r])=>r>Sm).map(([r])=>r),s=e.map(([r,o])=>`${r} ${o.toFixed(2)}`).join(", ");return n.length?{text:`Displacements lock to whole voxels along ${n.join(", ")} (${s}).`,tone:"doubt"}:{text:`No peak locking (first harmonic ${s}; above ${Sm} is locking).`,tone:"good"}}function wm(i,t){let e=Math.max(...[0,1,2].map(c=>qi(gl(i,c).map(Math.abs),.99)));if(!(e>0))return null;let n=qv*t/i.voxel,r=i.dt*1e6*n/e,o=e/(t/i.voxel),a=`largest displacement ${e.toFixed(1)} voxels, ${(100*o).toFixed(0)} % of a window`;return e>n?{text:`dt is too long: ${a}. Shorten it to ${Number(r.toPrecision(2))} µs.`,tone:"doubt",bestUs:r}:e<n/2?{text:`dt may be longer: ${a}. Up to ${Number(r.toPrecision(2))} µs keeps a quarter of a window, and errors weigh less.`,tone:null,bestUs:r}:{text:`dt suits the flow: ${a}.`,tone:"good",bestUs:r}}var Js={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Ks={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},eg=0,nd=1,ng=2;var Ca=1,ig=2,bo=3,js=0,ti=1,ni=2,vr=0,wo=1,id=2,sd=3,rd=4,sg=5;var yr=100,rg=101,og=102,ag=103,lg=104,cg=200,hg=201,ug=202,dg=203,od=204,ad=205,fg=206,pg=207,mg=208,gg=209,_g=210,xg=211,vg=212,yg=213,Sg=214,Xl=0,ql=1,Yl=2,ho=3,$l=4,Zl=5,Jl=6,Kl=7,bc=0,Mg=1,bg=2,ji=0,ld=1,cd=2,hd=3,ud=4,dd=5,fd=6,pd=7;var md=300,Sr=301,To=302,wc=303,Tc=304,jl=1e3,Zi=1001,Ql=1002,Pn=1003,wg=1004;var Pa=1005;var Ln=1006,Ec=1007;var ws=1008;var ii=1009,gd=1010,_d=1011,Eo=1012,Ac=1013,Fi=1014,wi=1015,Oi=1016,Rc=1017,Cc=1018,Mr=1020,xd=35902,vd=35899,yd=1021,Sd=1022,_i=1023,vs=1026,Ts=1027,Pc=1028,Ic=1029,Qs=1030,Lc=1031;var Dc=1033,Ia=33776,La=33777,Da=33778,Na=33779,Nc=35840,Uc=35841,Fc=35842,Oc=35843,Bc=36196,kc=37492,zc=37496,Vc=37488,Gc=37489,Ua=37490,Hc=37491,Wc=37808,Xc=37809,qc=37810,Yc=37811,$c=37812,Zc=37813,Jc=37814,Kc=37815,jc=37816,Qc=37817,th=37818,eh=37819,nh=37820,ih=37821,sh=36492,rh=36494,oh=36495,ah=36283,lh=36284,Fa=36285,ch=36286;var oa=2300,tc=2301,Hl=2302,Zu=2303,Ju=2400,Ku=2401,ju=2402;var Tg=3200;var hh=0,Eg=1,Es="",zn="srgb",aa="srgb-linear",la="linear",Pe="srgb";var Wl=7680;var Ag=519,Rg=512,Cg=513,Pg=514,Md=515,Ig=516,Lg=517,bd=518,wd=519,Dg=35044,uh=35048;var Td="300 es",bi=2e3,uo=2001;function $v(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Zv(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function ca(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Ng(){let i=ca("canvas");return i.style.display="block",i}var Tm={},fo=null;function Ed(...i){let t="THREE."+i.shift();fo?fo("log",t,...i):console.log(t,...i)}function Ug(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Zt(...i){i=Ug(i);let t="THREE."+i.shift();if(fo)fo("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function se(...i){i=Ug(i);let t="THREE."+i.shift();if(fo)fo("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function sa(...i){let t=i.join(" ");t in Tm||(Tm[t]=!0,Zt(...i))}function Fg(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var Og={[Xl]:Xl,[Yl]:Jl,[$l]:$l,[ho]:Zl,[ql]:ql,[Jl]:Yl,[Kl]:Kl,[Zl]:ho},Ui=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Bn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Em=1234567,lo=Math.PI/180,po=180/Math.PI;function Ao(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Bn[i&255]+Bn[i>>8&255]+Bn[i>>16&255]+Bn[i>>24&255]+"-"+Bn[t&255]+Bn[t>>8&255]+"-"+Bn[t>>16&15|64]+Bn[t>>24&255]+"-"+Bn[e&63|128]+Bn[e>>8&255]+"-"+Bn[e>>16&255]+Bn[e>>24&255]+Bn[n&255]+Bn[n>>8&255]+Bn[n>>16&255]+Bn[n>>24&255]).toLowerCase()}function ge(i,t,e){return Math.max(t,Math.min(e,i))}function Ad(i,t){return(i%t+t)%t}function Jv(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function Kv(i,t,e){return i!==t?(e-i)/(t-i):0}function ra(i,t,e){return(1-e)*i+e*t}function jv(i,t,e,n){return ra(i,t,1-Math.exp(-e*n))}function Qv(i,t=1){return t-Math.abs(Ad(i,t*2)-t)}function ty(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function ey(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function ny(i,t){return i+Math.floor(Math.random()*(t-i+1))}function iy(i,t){return i+Math.random()*(t-i)}function sy(i){return i*(.5-Math.random())}function ry(i){i!==void 0&&(Em=i);let t=Em+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function oy(i){return i*lo}function ay(i){return i*po}function ly(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function cy(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Rd(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function hy(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),c=o(e/2),l=r((t+n)/2),h=o((t+n)/2),d=r((t-n)/2),u=o((t-n)/2),f=r((n-t)/2),p=o((n-t)/2);switch(s){case"XYX":i.set(a*h,c*d,c*u,a*l);break;case"YZY":i.set(c*u,a*h,c*d,a*l);break;case"ZXZ":i.set(c*d,c*u,a*h,a*l);break;case"XZX":i.set(a*h,c*p,c*f,a*l);break;case"YXY":i.set(c*f,a*h,c*p,a*l);break;case"ZYZ":i.set(c*p,c*f,a*h,a*l);break;default:Zt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Cd(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Bg(i,t){if(t.constructor===Float32Array)return i;let e=Cd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function kg(i,t){if(t.constructor===Float32Array)return i;let e=Cd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var dh={DEG2RAD:lo,RAD2DEG:po,generateUUID:Ao,clamp:ge,euclideanModulo:Ad,mapLinear:Jv,inverseLerp:Kv,lerp:ra,damp:jv,pingpong:Qv,smoothstep:ty,smootherstep:ey,randInt:ny,randFloat:iy,randFloatSpread:sy,seededRandom:ry,degToRad:oy,radToDeg:ay,isPowerOfTwo:ly,ceilPowerOfTwo:cy,floorPowerOfTwo:Rd,setQuaternionFromProperEuler:hy,normalize:kg,denormalize:Bg},ee=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ge(this.x,t.x,e.x),this.y=ge(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ge(this.x,t,e),this.y=ge(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ge(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ge(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Qn=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let c=n[s+0],l=n[s+1],h=n[s+2],d=n[s+3],u=r[o+0],f=r[o+1],p=r[o+2],y=r[o+3];if(d!==y||c!==u||l!==f||h!==p){let m=c*u+l*f+h*p+d*y;m<0&&(u=-u,f=-f,p=-p,y=-y,m=-m);let g=1-a;if(m<.9995){let v=Math.acos(m),A=Math.sin(v);g=Math.sin(g*v)/A,a=Math.sin(a*v)/A,c=c*g+u*a,l=l*g+f*a,h=h*g+p*a,d=d*g+y*a}else{c=c*g+u*a,l=l*g+f*a,h=h*g+p*a,d=d*g+y*a;let v=1/Math.sqrt(c*c+l*l+h*h+d*d);c*=v,l*=v,h*=v,d*=v}}t[e]=c,t[e+1]=l,t[e+2]=h,t[e+3]=d}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],c=n[s+1],l=n[s+2],h=n[s+3],d=r[o],u=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+h*d+c*f-l*u,t[e+1]=c*p+h*u+l*d-a*f,t[e+2]=l*p+h*f+a*u-c*d,t[e+3]=h*p-a*d-c*u-l*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(n/2),h=a(s/2),d=a(r/2),u=c(n/2),f=c(s/2),p=c(r/2);switch(o){case"XYZ":this._x=u*h*d+l*f*p,this._y=l*f*d-u*h*p,this._z=l*h*p+u*f*d,this._w=l*h*d-u*f*p;break;case"YXZ":this._x=u*h*d+l*f*p,this._y=l*f*d-u*h*p,this._z=l*h*p-u*f*d,this._w=l*h*d+u*f*p;break;case"ZXY":this._x=u*h*d-l*f*p,this._y=l*f*d+u*h*p,this._z=l*h*p+u*f*d,this._w=l*h*d-u*f*p;break;case"ZYX":this._x=u*h*d-l*f*p,this._y=l*f*d+u*h*p,this._z=l*h*p-u*f*d,this._w=l*h*d+u*f*p;break;case"YZX":this._x=u*h*d+l*f*p,this._y=l*f*d+u*h*p,this._z=l*h*p-u*f*d,this._w=l*h*d-u*f*p;break;case"XZY":this._x=u*h*d-l*f*p,this._y=l*f*d-u*h*p,this._z=l*h*p+u*f*d,this._w=l*h*d+u*f*p;break;default:Zt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],c=e[9],l=e[2],h=e[6],d=e[10],u=n+a+d;if(u>0){let f=.5/Math.sqrt(u+1);this._w=.25/f,this._x=(h-c)*f,this._y=(r-l)*f,this._z=(o-s)*f}else if(n>a&&n>d){let f=2*Math.sqrt(1+n-a-d);this._w=(h-c)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+l)/f}else if(a>d){let f=2*Math.sqrt(1+a-n-d);this._w=(r-l)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(c+h)/f}else{let f=2*Math.sqrt(1+d-n-a);this._w=(o-s)/f,this._x=(r+l)/f,this._y=(c+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ge(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,c=e._y,l=e._z,h=e._w;return this._x=n*h+o*a+s*l-r*c,this._y=s*h+o*c+r*a-n*l,this._z=r*h+o*l+n*c-s*a,this._w=o*h-n*a-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let c=1-e;if(a<.9995){let l=Math.acos(a),h=Math.sin(l);c=Math.sin(c*l)/h,e=Math.sin(e*l)/h,this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this._onChangeCallback()}else this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},q=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Am.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Am.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*s-a*n),h=2*(a*e-r*s),d=2*(r*n-o*e);return this.x=e+c*l+o*d-a*h,this.y=n+c*h+a*l-r*d,this.z=s+c*d+r*h-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ge(this.x,t.x,e.x),this.y=ge(this.y,t.y,e.y),this.z=ge(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ge(this.x,t,e),this.y=ge(this.y,t,e),this.z=ge(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ge(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,c=e.z;return this.x=s*c-r*a,this.y=r*o-n*c,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Au.copy(this).projectOnVector(t),this.sub(Au)}reflect(t){return this.sub(Au.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ge(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Au=new q,Am=new Qn,re=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,c,l)}set(t,e,n,s,r,o,a,c,l){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=c,h[6]=n,h[7]=o,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],c=n[6],l=n[1],h=n[4],d=n[7],u=n[2],f=n[5],p=n[8],y=s[0],m=s[3],g=s[6],v=s[1],A=s[4],S=s[7],C=s[2],M=s[5],_=s[8];return r[0]=o*y+a*v+c*C,r[3]=o*m+a*A+c*M,r[6]=o*g+a*S+c*_,r[1]=l*y+h*v+d*C,r[4]=l*m+h*A+d*M,r[7]=l*g+h*S+d*_,r[2]=u*y+f*v+p*C,r[5]=u*m+f*A+p*M,r[8]=u*g+f*S+p*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8];return e*o*h-e*a*l-n*r*h+n*a*c+s*r*l-s*o*c}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],d=h*o-a*l,u=a*c-h*r,f=l*r-o*c,p=e*d+n*u+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/p;return t[0]=d*y,t[1]=(s*l-h*n)*y,t[2]=(a*n-s*o)*y,t[3]=u*y,t[4]=(h*e-s*c)*y,t[5]=(s*r-a*e)*y,t[6]=f*y,t[7]=(n*c-l*e)*y,t[8]=(o*e-n*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*o+l*a)+o+t,-s*l,s*c,-s*(-l*o+c*a)+a+e,0,0,1),this}scale(t,e){return sa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Ru.makeScale(t,e)),this}rotate(t){return sa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Ru.makeRotation(-t)),this}translate(t,e){return sa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Ru.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Ru=new re,Rm=new re().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Cm=new re().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function uy(){let i={enabled:!0,workingColorSpace:aa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pe&&(s.r=xs(s.r),s.g=xs(s.g),s.b=xs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pe&&(s.r=co(s.r),s.g=co(s.g),s.b=co(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Es?la:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[aa]:{primaries:t,whitePoint:n,transfer:la,toXYZ:Rm,fromXYZ:Cm,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:zn},outputColorSpaceConfig:{drawingBufferColorSpace:zn}},[zn]:{primaries:t,whitePoint:n,transfer:Pe,toXYZ:Rm,fromXYZ:Cm,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:zn}}}),i}var ye=uy();function xs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function co(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var $r,ec=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{$r===void 0&&($r=ca("canvas")),$r.width=t.width,$r.height=t.height;let s=$r.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=$r}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=ca("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=xs(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(xs(e[n]/255)*255):e[n]=xs(e[n]);return{data:e,width:t.width,height:t.height}}else return Zt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},dy=0,mo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:dy++}),this.uuid=Ao(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Cu(s[o].image)):r.push(Cu(s[o]))}else r=Cu(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function Cu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ec.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Zt("Texture: Unable to serialize Texture."),{})}var fy=0,Pu=new q,ei=class i extends Ui{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=Zi,s=Zi,r=Ln,o=ws,a=_i,c=ii,l=i.DEFAULT_ANISOTROPY,h=Es){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:fy++}),this.uuid=Ao(),this.name="",this.source=new mo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new ee(0,0),this.repeat=new ee(1,1),this.center=new ee(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new re,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Pu).x}get height(){return this.source.getSize(Pu).y}get depth(){return this.source.getSize(Pu).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Zt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Zt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==md)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case jl:t.x=t.x-Math.floor(t.x);break;case Zi:t.x=t.x<0?0:1;break;case Ql:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case jl:t.y=t.y-Math.floor(t.y);break;case Zi:t.y=t.y<0?0:1;break;case Ql:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};ei.DEFAULT_IMAGE=null;ei.DEFAULT_MAPPING=md;ei.DEFAULT_ANISOTROPY=1;var $e=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,c=t.elements,l=c[0],h=c[4],d=c[8],u=c[1],f=c[5],p=c[9],y=c[2],m=c[6],g=c[10];if(Math.abs(h-u)<.01&&Math.abs(d-y)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+y)<.1&&Math.abs(p+m)<.1&&Math.abs(l+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let A=(l+1)/2,S=(f+1)/2,C=(g+1)/2,M=(h+u)/4,_=(d+y)/4,b=(p+m)/4;return A>S&&A>C?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=M/n,r=_/n):S>C?S<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),n=M/s,r=b/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=_/r,s=b/r),this.set(n,s,r,e),this}let v=Math.sqrt((m-p)*(m-p)+(d-y)*(d-y)+(u-h)*(u-h));return Math.abs(v)<.001&&(v=1),this.x=(m-p)/v,this.y=(d-y)/v,this.z=(u-h)/v,this.w=Math.acos((l+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ge(this.x,t.x,e.x),this.y=ge(this.y,t.y,e.y),this.z=ge(this.z,t.z,e.z),this.w=ge(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ge(this.x,t,e),this.y=ge(this.y,t,e),this.z=ge(this.z,t,e),this.w=ge(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ge(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},nc=class extends Ui{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ln,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new $e(0,0,t,e),this.scissorTest=!1,this.viewport=new $e(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new ei({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Ln,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new mo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},mi=class extends nc{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},ha=class extends ei{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Pn,this.minFilter=Pn,this.wrapR=Zi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var ic=class extends ei{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Pn,this.minFilter=Pn,this.wrapR=Zi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Ae=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,c,l,h,d,u,f,p,y,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,c,l,h,d,u,f,p,y,m)}set(t,e,n,s,r,o,a,c,l,h,d,u,f,p,y,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=c,g[2]=l,g[6]=h,g[10]=d,g[14]=u,g[3]=f,g[7]=p,g[11]=y,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/Zr.setFromMatrixColumn(t,0).length(),r=1/Zr.setFromMatrixColumn(t,1).length(),o=1/Zr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),c=Math.cos(s),l=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let u=o*h,f=o*d,p=a*h,y=a*d;e[0]=c*h,e[4]=-c*d,e[8]=l,e[1]=f+p*l,e[5]=u-y*l,e[9]=-a*c,e[2]=y-u*l,e[6]=p+f*l,e[10]=o*c}else if(t.order==="YXZ"){let u=c*h,f=c*d,p=l*h,y=l*d;e[0]=u+y*a,e[4]=p*a-f,e[8]=o*l,e[1]=o*d,e[5]=o*h,e[9]=-a,e[2]=f*a-p,e[6]=y+u*a,e[10]=o*c}else if(t.order==="ZXY"){let u=c*h,f=c*d,p=l*h,y=l*d;e[0]=u-y*a,e[4]=-o*d,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*h,e[9]=y-u*a,e[2]=-o*l,e[6]=a,e[10]=o*c}else if(t.order==="ZYX"){let u=o*h,f=o*d,p=a*h,y=a*d;e[0]=c*h,e[4]=p*l-f,e[8]=u*l+y,e[1]=c*d,e[5]=y*l+u,e[9]=f*l-p,e[2]=-l,e[6]=a*c,e[10]=o*c}else if(t.order==="YZX"){let u=o*c,f=o*l,p=a*c,y=a*l;e[0]=c*h,e[4]=y-u*d,e[8]=p*d+f,e[1]=d,e[5]=o*h,e[9]=-a*h,e[2]=-l*h,e[6]=f*d+p,e[10]=u-y*d}else if(t.order==="XZY"){let u=o*c,f=o*l,p=a*c,y=a*l;e[0]=c*h,e[4]=-d,e[8]=l*h,e[1]=u*d+y,e[5]=o*h,e[9]=f*d-p,e[2]=p*d-f,e[6]=a*h,e[10]=y*d+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(py,t,my)}lookAt(t,e,n){let s=this.elements;return di.subVectors(t,e),di.lengthSq()===0&&(di.z=1),di.normalize(),zs.crossVectors(n,di),zs.lengthSq()===0&&(Math.abs(n.z)===1?di.x+=1e-4:di.z+=1e-4,di.normalize(),zs.crossVectors(n,di)),zs.normalize(),_l.crossVectors(di,zs),s[0]=zs.x,s[4]=_l.x,s[8]=di.x,s[1]=zs.y,s[5]=_l.y,s[9]=di.y,s[2]=zs.z,s[6]=_l.z,s[10]=di.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],c=n[8],l=n[12],h=n[1],d=n[5],u=n[9],f=n[13],p=n[2],y=n[6],m=n[10],g=n[14],v=n[3],A=n[7],S=n[11],C=n[15],M=s[0],_=s[4],b=s[8],N=s[12],R=s[1],P=s[5],O=s[9],z=s[13],D=s[2],H=s[6],W=s[10],V=s[14],ht=s[3],J=s[7],k=s[11],Q=s[15];return r[0]=o*M+a*R+c*D+l*ht,r[4]=o*_+a*P+c*H+l*J,r[8]=o*b+a*O+c*W+l*k,r[12]=o*N+a*z+c*V+l*Q,r[1]=h*M+d*R+u*D+f*ht,r[5]=h*_+d*P+u*H+f*J,r[9]=h*b+d*O+u*W+f*k,r[13]=h*N+d*z+u*V+f*Q,r[2]=p*M+y*R+m*D+g*ht,r[6]=p*_+y*P+m*H+g*J,r[10]=p*b+y*O+m*W+g*k,r[14]=p*N+y*z+m*V+g*Q,r[3]=v*M+A*R+S*D+C*ht,r[7]=v*_+A*P+S*H+C*J,r[11]=v*b+A*O+S*W+C*k,r[15]=v*N+A*z+S*V+C*Q,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],c=t[9],l=t[13],h=t[2],d=t[6],u=t[10],f=t[14],p=t[3],y=t[7],m=t[11],g=t[15],v=c*f-l*u,A=a*f-l*d,S=a*u-c*d,C=o*f-l*h,M=o*u-c*h,_=o*d-a*h;return e*(y*v-m*A+g*S)-n*(p*v-m*C+g*M)+s*(p*A-y*C+g*_)-r*(p*S-y*M+m*_)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],c=t[2],l=t[6],h=t[10];return e*(o*h-a*l)-n*(r*h-a*c)+s*(r*l-o*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],d=t[9],u=t[10],f=t[11],p=t[12],y=t[13],m=t[14],g=t[15],v=e*a-n*o,A=e*c-s*o,S=e*l-r*o,C=n*c-s*a,M=n*l-r*a,_=s*l-r*c,b=h*y-d*p,N=h*m-u*p,R=h*g-f*p,P=d*m-u*y,O=d*g-f*y,z=u*g-f*m,D=v*z-A*O+S*P+C*R-M*N+_*b;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/D;return t[0]=(a*z-c*O+l*P)*H,t[1]=(s*O-n*z-r*P)*H,t[2]=(y*_-m*M+g*C)*H,t[3]=(u*M-d*_-f*C)*H,t[4]=(c*R-o*z-l*N)*H,t[5]=(e*z-s*R+r*N)*H,t[6]=(m*S-p*_-g*A)*H,t[7]=(h*_-u*S+f*A)*H,t[8]=(o*O-a*R+l*b)*H,t[9]=(n*R-e*O-r*b)*H,t[10]=(p*M-y*S+g*v)*H,t[11]=(d*S-h*M-f*v)*H,t[12]=(a*N-o*P-c*b)*H,t[13]=(e*P-n*N+s*b)*H,t[14]=(y*A-p*C-m*v)*H,t[15]=(h*C-d*A+u*v)*H,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,c=t.z,l=r*o,h=r*a;return this.set(l*o+n,l*a-s*c,l*c+s*a,0,l*a+s*c,h*a+n,h*c-s*o,0,l*c-s*a,h*c+s*o,r*c*c+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,c=e._w,l=r+r,h=o+o,d=a+a,u=r*l,f=r*h,p=r*d,y=o*h,m=o*d,g=a*d,v=c*l,A=c*h,S=c*d,C=n.x,M=n.y,_=n.z;return s[0]=(1-(y+g))*C,s[1]=(f+S)*C,s[2]=(p-A)*C,s[3]=0,s[4]=(f-S)*M,s[5]=(1-(u+g))*M,s[6]=(m+v)*M,s[7]=0,s[8]=(p+A)*_,s[9]=(m-v)*_,s[10]=(1-(u+y))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=Zr.set(s[0],s[1],s[2]).length(),a=Zr.set(s[4],s[5],s[6]).length(),c=Zr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Li.copy(this);let l=1/o,h=1/a,d=1/c;return Li.elements[0]*=l,Li.elements[1]*=l,Li.elements[2]*=l,Li.elements[4]*=h,Li.elements[5]*=h,Li.elements[6]*=h,Li.elements[8]*=d,Li.elements[9]*=d,Li.elements[10]*=d,e.setFromRotationMatrix(Li),n.x=o,n.y=a,n.z=c,this}makePerspective(t,e,n,s,r,o,a=bi,c=!1){let l=this.elements,h=2*r/(e-t),d=2*r/(n-s),u=(e+t)/(e-t),f=(n+s)/(n-s),p,y;if(c)p=r/(o-r),y=o*r/(o-r);else if(a===bi)p=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===uo)p=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=u,l[12]=0,l[1]=0,l[5]=d,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=p,l[14]=y,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=bi,c=!1){let l=this.elements,h=2/(e-t),d=2/(n-s),u=-(e+t)/(e-t),f=-(n+s)/(n-s),p,y;if(c)p=1/(o-r),y=o/(o-r);else if(a===bi)p=-2/(o-r),y=-(o+r)/(o-r);else if(a===uo)p=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=0,l[12]=u,l[1]=0,l[5]=d,l[9]=0,l[13]=f,l[2]=0,l[6]=0,l[10]=p,l[14]=y,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Zr=new q,Li=new Ae,py=new q(0,0,0),my=new q(1,1,1),zs=new q,_l=new q,di=new q,Pm=new Ae,Im=new Qn,ys=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],h=s[9],d=s[2],u=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(ge(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,l),this._z=0);break;case"YXZ":this._x=Math.asin(-ge(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(ge(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-ge(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,f),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(ge(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ge(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Zt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return Pm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Pm,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Im.setFromEuler(this),this.setFromQuaternion(Im,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ys.DEFAULT_ORDER="XYZ";var ua=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},gy=0,Lm=new q,Jr=new Qn,us=new Ae,xl=new q,Ko=new q,_y=new q,xy=new Qn,Dm=new q(1,0,0),Nm=new q(0,1,0),Um=new q(0,0,1),Fm={type:"added"},vy={type:"removed"},Kr={type:"childadded",child:null},Iu={type:"childremoved",child:null},Gn=class i extends Ui{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:gy++}),this.uuid=Ao(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new q,e=new ys,n=new Qn,s=new q(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ae},normalMatrix:{value:new re}}),this.matrix=new Ae,this.matrixWorld=new Ae,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ua,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Jr.setFromAxisAngle(t,e),this.quaternion.multiply(Jr),this}rotateOnWorldAxis(t,e){return Jr.setFromAxisAngle(t,e),this.quaternion.premultiply(Jr),this}rotateX(t){return this.rotateOnAxis(Dm,t)}rotateY(t){return this.rotateOnAxis(Nm,t)}rotateZ(t){return this.rotateOnAxis(Um,t)}translateOnAxis(t,e){return Lm.copy(t).applyQuaternion(this.quaternion),this.position.add(Lm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Dm,t)}translateY(t){return this.translateOnAxis(Nm,t)}translateZ(t){return this.translateOnAxis(Um,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(us.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?xl.copy(t):xl.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ko.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?us.lookAt(Ko,xl,this.up):us.lookAt(xl,Ko,this.up),this.quaternion.setFromRotationMatrix(us),s&&(us.extractRotation(s.matrixWorld),Jr.setFromRotationMatrix(us),this.quaternion.premultiply(Jr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(se("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Fm),Kr.child=t,this.dispatchEvent(Kr),Kr.child=null):se("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(vy),Iu.child=t,this.dispatchEvent(Iu),Iu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),us.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),us.multiply(t.parent.matrixWorld)),t.applyMatrix4(us),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Fm),Kr.child=t,this.dispatchEvent(Kr),Kr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ko,t,_y),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ko,xy,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let d=c[l];r(t.shapes,d)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(t.materials,this.material[c]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(t.animations,c))}}if(e){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),h=o(t.images),d=o(t.shapes),u=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(n.geometries=a),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),h.length>0&&(n.images=h),d.length>0&&(n.shapes=d),u.length>0&&(n.skeletons=u),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let c=[];for(let l in a){let h=a[l];delete h.metadata,c.push(h)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Gn.DEFAULT_UP=new q(0,1,0);Gn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Gn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var _s=class extends Gn{constructor(){super(),this.isGroup=!0,this.type="Group"}},yy={type:"move"},go=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new _s,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new _s,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new q,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new q),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new _s,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new q,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new q,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){o=!0;for(let y of t.hand.values()){let m=e.getJointPose(y,n),g=this._getHandJoint(l,y);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=l.joints["index-finger-tip"],d=l.joints["thumb-tip"],u=h.position.distanceTo(d.position),f=.02,p=.005;l.inputState.pinching&&u>f+p?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&u<=f-p&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(yy)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new _s;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},zg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Vs={h:0,s:0,l:0},vl={h:0,s:0,l:0};function Lu(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var fe=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=zn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ye.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=ye.workingColorSpace){return this.r=t,this.g=e,this.b=n,ye.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=ye.workingColorSpace){if(t=Ad(t,1),e=ge(e,0,1),n=ge(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=Lu(o,r,t+1/3),this.g=Lu(o,r,t),this.b=Lu(o,r,t-1/3)}return ye.colorSpaceToWorking(this,s),this}setStyle(t,e=zn){function n(r){r!==void 0&&parseFloat(r)<1&&Zt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Zt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Zt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=zn){let n=zg[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Zt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=xs(t.r),this.g=xs(t.g),this.b=xs(t.b),this}copyLinearToSRGB(t){return this.r=co(t.r),this.g=co(t.g),this.b=co(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=zn){return ye.workingToColorSpace(kn.copy(this),t),Math.round(ge(kn.r*255,0,255))*65536+Math.round(ge(kn.g*255,0,255))*256+Math.round(ge(kn.b*255,0,255))}getHexString(t=zn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ye.workingColorSpace){ye.workingToColorSpace(kn.copy(this),e);let n=kn.r,s=kn.g,r=kn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),c,l,h=(a+o)/2;if(a===o)c=0,l=0;else{let d=o-a;switch(l=h<=.5?d/(o+a):d/(2-o-a),o){case n:c=(s-r)/d+(s<r?6:0);break;case s:c=(r-n)/d+2;break;case r:c=(n-s)/d+4;break}c/=6}return t.h=c,t.s=l,t.l=h,t}getRGB(t,e=ye.workingColorSpace){return ye.workingToColorSpace(kn.copy(this),e),t.r=kn.r,t.g=kn.g,t.b=kn.b,t}getStyle(t=zn){ye.workingToColorSpace(kn.copy(this),t);let e=kn.r,n=kn.g,s=kn.b;return t!==zn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Vs),this.setHSL(Vs.h+t,Vs.s+e,Vs.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Vs),t.getHSL(vl);let n=ra(Vs.h,vl.h,e),s=ra(Vs.s,vl.s,e),r=ra(Vs.l,vl.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},kn=new fe;fe.NAMES=zg;var da=class extends Gn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ys,this.environmentIntensity=1,this.environmentRotation=new ys,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Di=new q,ds=new q,Du=new q,fs=new q,jr=new q,Qr=new q,Om=new q,Nu=new q,Uu=new q,Fu=new q,Ou=new $e,Bu=new $e,ku=new $e,gs=class i{constructor(t=new q,e=new q,n=new q){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Di.subVectors(t,e),s.cross(Di);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Di.subVectors(s,e),ds.subVectors(n,e),Du.subVectors(t,e);let o=Di.dot(Di),a=Di.dot(ds),c=Di.dot(Du),l=ds.dot(ds),h=ds.dot(Du),d=o*l-a*a;if(d===0)return r.set(0,0,0),null;let u=1/d,f=(l*c-a*h)*u,p=(o*h-a*c)*u;return r.set(1-f-p,p,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,fs)===null?!1:fs.x>=0&&fs.y>=0&&fs.x+fs.y<=1}static getInterpolation(t,e,n,s,r,o,a,c){return this.getBarycoord(t,e,n,s,fs)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,fs.x),c.addScaledVector(o,fs.y),c.addScaledVector(a,fs.z),c)}static getInterpolatedAttribute(t,e,n,s,r,o){return Ou.setScalar(0),Bu.setScalar(0),ku.setScalar(0),Ou.fromBufferAttribute(t,e),Bu.fromBufferAttribute(t,n),ku.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Ou,r.x),o.addScaledVector(Bu,r.y),o.addScaledVector(ku,r.z),o}static isFrontFacing(t,e,n,s){return Di.subVectors(n,e),ds.subVectors(t,e),Di.cross(ds).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Di.subVectors(this.c,this.b),ds.subVectors(this.a,this.b),Di.cross(ds).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;jr.subVectors(s,n),Qr.subVectors(r,n),Nu.subVectors(t,n);let c=jr.dot(Nu),l=Qr.dot(Nu);if(c<=0&&l<=0)return e.copy(n);Uu.subVectors(t,s);let h=jr.dot(Uu),d=Qr.dot(Uu);if(h>=0&&d<=h)return e.copy(s);let u=c*d-h*l;if(u<=0&&c>=0&&h<=0&&c-h>0)return o=c/(c-h),e.copy(n).addScaledVector(jr,o);Fu.subVectors(t,r);let f=jr.dot(Fu),p=Qr.dot(Fu);if(p>=0&&f<=p)return e.copy(r);let y=f*l-c*p;if(y<=0&&l>=0&&p<=0)return a=l/(l-p),e.copy(n).addScaledVector(Qr,a);let m=h*p-f*d;if(m<=0&&d-h>=0&&f-p>=0)return Om.subVectors(r,s),a=(d-h)/(d-h+(f-p)),e.copy(s).addScaledVector(Om,a);let g=1/(m+y+u);return o=y*g,a=u*g,e.copy(n).addScaledVector(jr,o).addScaledVector(Qr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Ji=class{constructor(t=new q(1/0,1/0,1/0),e=new q(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Ni.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Ni.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Ni.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ni):Ni.fromBufferAttribute(r,o),Ni.applyMatrix4(t.matrixWorld),this.expandByPoint(Ni);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),yl.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),yl.copy(n.boundingBox)),yl.applyMatrix4(t.matrixWorld),this.union(yl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ni),Ni.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(jo),Sl.subVectors(this.max,jo),to.subVectors(t.a,jo),eo.subVectors(t.b,jo),no.subVectors(t.c,jo),Gs.subVectors(eo,to),Hs.subVectors(no,eo),ur.subVectors(to,no);let e=[0,-Gs.z,Gs.y,0,-Hs.z,Hs.y,0,-ur.z,ur.y,Gs.z,0,-Gs.x,Hs.z,0,-Hs.x,ur.z,0,-ur.x,-Gs.y,Gs.x,0,-Hs.y,Hs.x,0,-ur.y,ur.x,0];return!zu(e,to,eo,no,Sl)||(e=[1,0,0,0,1,0,0,0,1],!zu(e,to,eo,no,Sl))?!1:(Ml.crossVectors(Gs,Hs),e=[Ml.x,Ml.y,Ml.z],zu(e,to,eo,no,Sl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ni).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ni).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ps[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ps[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ps[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ps[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ps[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ps[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ps[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ps[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ps),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ps=[new q,new q,new q,new q,new q,new q,new q,new q],Ni=new q,yl=new Ji,to=new q,eo=new q,no=new q,Gs=new q,Hs=new q,ur=new q,jo=new q,Sl=new q,Ml=new q,dr=new q;function zu(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){dr.fromArray(i,r);let a=s.x*Math.abs(dr.x)+s.y*Math.abs(dr.y)+s.z*Math.abs(dr.z),c=t.dot(dr),l=e.dot(dr),h=n.dot(dr);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>a)return!1}return!0}var dn=new q,bl=new ee,Sy=0,Vn=class extends Ui{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Sy++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Dg,this.updateRanges=[],this.gpuType=wi,this.version=0,this._normalizationScale=t!==void 0?Cd(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)bl.fromBufferAttribute(this,e),bl.applyMatrix3(t),this.setXY(e,bl.x,bl.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)dn.fromBufferAttribute(this,e),dn.applyMatrix3(t),this.setXYZ(e,dn.x,dn.y,dn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)dn.fromBufferAttribute(this,e),dn.applyMatrix4(t),this.setXYZ(e,dn.x,dn.y,dn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)dn.fromBufferAttribute(this,e),dn.applyNormalMatrix(t),this.setXYZ(e,dn.x,dn.y,dn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)dn.fromBufferAttribute(this,e),dn.transformDirection(t),this.setXYZ(e,dn.x,dn.y,dn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Bg(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):kg(t,this.array)}};var fa=class extends Vn{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var pa=class extends Vn{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var xn=class extends Vn{constructor(t,e,n){super(new Float32Array(t),e,n)}},My=new Ji,Qo=new q,Vu=new q,Ss=class{constructor(t=new q,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):My.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Qo.subVectors(t,this.center);let e=Qo.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Qo,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Vu.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Qo.copy(t.center).add(Vu)),this.expandByPoint(Qo.copy(t.center).sub(Vu))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},by=0,Mi=new Ae,Gu=new Gn,io=new q,fi=new Ji,ta=new Ji,Cn=new q,Dn=class i extends Ui{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:by++}),this.uuid=Ao(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new($v(t)?pa:fa)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new re().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Mi.makeRotationFromQuaternion(t),this.applyMatrix4(Mi),this}rotateX(t){return Mi.makeRotationX(t),this.applyMatrix4(Mi),this}rotateY(t){return Mi.makeRotationY(t),this.applyMatrix4(Mi),this}rotateZ(t){return Mi.makeRotationZ(t),this.applyMatrix4(Mi),this}translate(t,e,n){return Mi.makeTranslation(t,e,n),this.applyMatrix4(Mi),this}scale(t,e,n){return Mi.makeScale(t,e,n),this.applyMatrix4(Mi),this}lookAt(t){return Gu.lookAt(t),Gu.updateMatrix(),this.applyMatrix4(Gu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(io).negate(),this.translate(io.x,io.y,io.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new xn(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Zt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ji);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){se("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new q(-1/0,-1/0,-1/0),new q(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];fi.setFromBufferAttribute(r),this.morphTargetsRelative?(Cn.addVectors(this.boundingBox.min,fi.min),this.boundingBox.expandByPoint(Cn),Cn.addVectors(this.boundingBox.max,fi.max),this.boundingBox.expandByPoint(Cn)):(this.boundingBox.expandByPoint(fi.min),this.boundingBox.expandByPoint(fi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&se('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ss);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){se("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new q,1/0);return}if(t){let n=this.boundingSphere.center;if(fi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];ta.setFromBufferAttribute(a),this.morphTargetsRelative?(Cn.addVectors(fi.min,ta.min),fi.expandByPoint(Cn),Cn.addVectors(fi.max,ta.max),fi.expandByPoint(Cn)):(fi.expandByPoint(ta.min),fi.expandByPoint(ta.max))}fi.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Cn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Cn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],c=this.morphTargetsRelative;for(let l=0,h=a.count;l<h;l++)Cn.fromBufferAttribute(a,l),c&&(io.fromBufferAttribute(t,l),Cn.add(io)),s=Math.max(s,n.distanceToSquared(Cn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&se('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){se("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Vn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(n.count);for(let N=0;N<n.count;N++)a[N]=new q,c[N]=new q;let h=new q,d=new q,u=new q,f=new ee,p=new ee,y=new ee,m=new q,g=new q;function v(N,R,P){l[N]=l[R]=l[P]=1,h.fromBufferAttribute(n,N),d.fromBufferAttribute(n,R),u.fromBufferAttribute(n,P),f.fromBufferAttribute(r,N),p.fromBufferAttribute(r,R),y.fromBufferAttribute(r,P),d.sub(h),u.sub(h),p.sub(f),y.sub(f);let O=1/(p.x*y.y-y.x*p.y);isFinite(O)&&(m.copy(d).multiplyScalar(y.y).addScaledVector(u,-p.y).multiplyScalar(O),g.copy(u).multiplyScalar(p.x).addScaledVector(d,-y.x).multiplyScalar(O),a[N].add(m),a[R].add(m),a[P].add(m),c[N].add(g),c[R].add(g),c[P].add(g))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let N=0,R=A.length;N<R;++N){let P=A[N],O=P.start,z=P.count;for(let D=O,H=O+z;D<H;D+=3)v(t.getX(D+0),t.getX(D+1),t.getX(D+2))}let S=new q,C=new q,M=new q,_=new q;function b(N){M.fromBufferAttribute(s,N),_.copy(M);let R=a[N];S.copy(R),S.sub(M.multiplyScalar(M.dot(R))).normalize(),C.crossVectors(_,R);let O=C.dot(c[N])<0?-1:1;o.setXYZW(N,S.x,S.y,S.z,O)}for(let N=0,R=n.count;N<R;++N)l[N]&&b(N);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Vn(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let u=0,f=n.count;u<f;u++)n.setXYZ(u,0,0,0);let s=new q,r=new q,o=new q,a=new q,c=new q,l=new q,h=new q,d=new q;if(t)for(let u=0,f=t.count;u<f;u+=3){let p=t.getX(u+0),y=t.getX(u+1),m=t.getX(u+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,m),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),a.fromBufferAttribute(n,p),c.fromBufferAttribute(n,y),l.fromBufferAttribute(n,m),a.add(h),c.add(h),l.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(y,c.x,c.y,c.z),n.setXYZ(m,l.x,l.y,l.z)}else for(let u=0,f=e.count;u<f;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),o.fromBufferAttribute(e,u+2),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Cn.fromBufferAttribute(t,e),Cn.normalize(),t.setXYZ(e,Cn.x,Cn.y,Cn.z)}toNonIndexed(){function t(a,c){let l=a.array,h=a.itemSize,d=a.normalized,u=new l.constructor(c.length*h),f=0,p=0;for(let y=0,m=c.length;y<m;y++){a.isInterleavedBufferAttribute?f=c[y]*a.data.stride+a.offset:f=c[y]*h;for(let g=0;g<h;g++)u[p++]=l[f++]}return new Vn(u,h,d)}if(this.index===null)return Zt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=t(c,n);e.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let h=0,d=l.length;h<d;h++){let u=l[h],f=t(u,n);c.push(f)}e.morphAttributes[a]=c}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let c in n){let l=n[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let d=0,u=l.length;d<u;d++){let f=l[d];h.push(f.toJSON(t.data))}h.length>0&&(s[c]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let l in s){let h=s[l];this.setAttribute(l,h.clone(e))}let r=t.morphAttributes;for(let l in r){let h=[],d=r[l];for(let u=0,f=d.length;u<f;u++)h.push(d[u].clone(e));this.morphAttributes[l]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,h=o.length;l<h;l++){let d=o[l];this.addGroup(d.start,d.count,d.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Hu=new q,wy=new q,Ty=new re,pi=class{constructor(t=new q(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Hu.subVectors(n,e).cross(wy.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(Hu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Ty.getNormalMatrix(t),s=this.coplanarPoint(Hu).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Ey=0,Ms=class extends Ui{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Ey++}),this.uuid=Ao(),this.name="",this.type="Material",this.blending=wo,this.side=js,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=od,this.blendDst=ad,this.blendEquation=yr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new fe(0,0,0),this.blendAlpha=0,this.depthFunc=ho,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Ag,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Wl,this.stencilZFail=Wl,this.stencilZPass=Wl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Zt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Zt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new fe().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new pi().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new ee().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ee().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var ms=new q,Wu=new q,wl=new q,Tl=new q,mr=class{constructor(t=new q,e=new q(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,ms)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=ms.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(ms.copy(this.origin).addScaledVector(this.direction,e),ms.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Wu.copy(t).add(e).multiplyScalar(.5),wl.copy(e).sub(t).normalize(),Tl.copy(this.origin).sub(Wu);let r=t.distanceTo(e)*.5,o=-this.direction.dot(wl),a=Tl.dot(this.direction),c=-Tl.dot(wl),l=Tl.lengthSq(),h=Math.abs(1-o*o),d,u,f,p;if(h>0)if(d=o*c-a,u=o*a-c,p=r*h,d>=0)if(u>=-p)if(u<=p){let y=1/h;d*=y,u*=y,f=d*(d+o*u+2*a)+u*(o*d+u+2*c)+l}else u=r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*c)+l;else u=-r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*c)+l;else u<=-p?(d=Math.max(0,-(-o*r+a)),u=d>0?-r:Math.min(Math.max(-r,-c),r),f=-d*d+u*(u+2*c)+l):u<=p?(d=0,u=Math.min(Math.max(-r,-c),r),f=u*(u+2*c)+l):(d=Math.max(0,-(o*r+a)),u=d>0?r:Math.min(Math.max(-r,-c),r),f=-d*d+u*(u+2*c)+l);else u=o>0?-r:r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Wu).addScaledVector(wl,u),f}intersectSphere(t,e){if(t.radius<0)return null;ms.subVectors(t.center,this.origin);let n=ms.dot(this.direction),s=ms.dot(ms)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,c=n+o;return c<0?null:a<0?this.at(c,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,c,l=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return l>=0?(n=(t.min.x-u.x)*l,s=(t.max.x-u.x)*l):(n=(t.max.x-u.x)*l,s=(t.min.x-u.x)*l),h>=0?(r=(t.min.y-u.y)*h,o=(t.max.y-u.y)*h):(r=(t.max.y-u.y)*h,o=(t.min.y-u.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(t.min.z-u.z)*d,c=(t.max.z-u.z)*d):(a=(t.max.z-u.z)*d,c=(t.min.z-u.z)*d),n>c||a>s)||((a>n||n!==n)&&(n=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,ms)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,h=a.z,d=t.x-o.x,u=t.y-o.y,f=t.z-o.z,p=e.x-o.x,y=e.y-o.y,m=e.z-o.z,g=n.x-o.x,v=n.y-o.y,A=n.z-o.z,S=Math.abs(c),C=Math.abs(l),M=Math.abs(h),_,b,N,R,P,O,z,D,H,W,V,ht;if(S>=C&&S>=M?(N=c,O=d,H=p,ht=g,c>=0?(_=l,b=h,R=u,P=f,z=y,D=m,W=v,V=A):(_=h,b=l,R=f,P=u,z=m,D=y,W=A,V=v)):C>=M?(N=l,O=u,H=y,ht=v,l>=0?(_=h,b=c,R=f,P=d,z=m,D=p,W=A,V=g):(_=c,b=h,R=d,P=f,z=p,D=m,W=g,V=A)):(N=h,O=f,H=m,ht=A,h>=0?(_=c,b=l,R=d,P=u,z=p,D=y,W=g,V=v):(_=l,b=c,R=u,P=d,z=y,D=p,W=v,V=g)),N===0)return null;let J=_/N,k=b/N,Q=1/N,lt=R-J*O,ot=P-k*O,K=z-J*H,ut=D-k*H,ft=W-J*ht,_t=V-k*ht,mt=ft*ut-_t*K,Bt=lt*_t-ot*ft,Kt=K*ot-ut*lt;if(s){if(mt<0||Bt<0||Kt<0)return null}else if((mt<0||Bt<0||Kt<0)&&(mt>0||Bt>0||Kt>0))return null;let Ft=mt+Bt+Kt;if(Ft===0)return null;let ce=Q*(mt*O+Bt*H+Kt*ht);return(Ft>0?ce<0:ce>0)?null:this.at(ce/Ft,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},_o=class extends Ms{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new fe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ys,this.combine=bc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Bm=new Ae,fr=new mr,El=new Ss,km=new q,Al=new q,Rl=new q,Cl=new q,Xu=new q,Pl=new q,zm=new q,Il=new q,Hn=class extends Gn{constructor(t=new Dn,e=new _o){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Pl.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=a[c],d=r[c];h!==0&&(Xu.fromBufferAttribute(d,t),o?Pl.addScaledVector(Xu,h):Pl.addScaledVector(Xu.sub(e),h))}e.add(Pl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),El.copy(n.boundingSphere),El.applyMatrix4(r),fr.copy(t.ray).recast(t.near),!(El.containsPoint(fr.origin)===!1&&(fr.intersectSphere(El,km)===null||fr.origin.distanceToSquared(km)>(t.far-t.near)**2))&&(Bm.copy(r).invert(),fr.copy(t.ray).applyMatrix4(Bm),!(n.boundingBox!==null&&fr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,fr)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,y=u.length;p<y;p++){let m=u[p],g=o[m.materialIndex],v=Math.max(m.start,f.start),A=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let S=v,C=A;S<C;S+=3){let M=a.getX(S),_=a.getX(S+1),b=a.getX(S+2);s=Ll(this,g,t,n,l,h,d,M,_,b),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let m=p,g=y;m<g;m+=3){let v=a.getX(m),A=a.getX(m+1),S=a.getX(m+2);s=Ll(this,o,t,n,l,h,d,v,A,S),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let p=0,y=u.length;p<y;p++){let m=u[p],g=o[m.materialIndex],v=Math.max(m.start,f.start),A=Math.min(c.count,Math.min(m.start+m.count,f.start+f.count));for(let S=v,C=A;S<C;S+=3){let M=S,_=S+1,b=S+2;s=Ll(this,g,t,n,l,h,d,M,_,b),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),y=Math.min(c.count,f.start+f.count);for(let m=p,g=y;m<g;m+=3){let v=m,A=m+1,S=m+2;s=Ll(this,o,t,n,l,h,d,v,A,S),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function Ay(i,t,e,n,s,r,o,a){let c;if(t.side===ti?c=n.intersectTriangle(o,r,s,!0,a):c=n.intersectTriangle(s,r,o,t.side===js,a),c===null)return null;Il.copy(a),Il.applyMatrix4(i.matrixWorld);let l=e.ray.origin.distanceTo(Il);return l<e.near||l>e.far?null:{distance:l,point:Il.clone(),object:i}}function Ll(i,t,e,n,s,r,o,a,c,l){i.getVertexPosition(a,Al),i.getVertexPosition(c,Rl),i.getVertexPosition(l,Cl);let h=Ay(i,t,e,n,Al,Rl,Cl,zm);if(h){let d=new q;gs.getBarycoord(zm,Al,Rl,Cl,d),s&&(h.uv=gs.getInterpolatedAttribute(s,a,c,l,d,new ee)),r&&(h.uv1=gs.getInterpolatedAttribute(r,a,c,l,d,new ee)),o&&(h.normal=gs.getInterpolatedAttribute(o,a,c,l,d,new q),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:c,c:l,normal:new q,materialIndex:0};gs.getNormal(Al,Rl,Cl,u.normal),h.face=u,h.barycoord=d}return h}var gr=class extends ei{constructor(t=null,e=1,n=1,s,r,o,a,c,l=Pn,h=Pn,d,u){super(null,o,a,c,l,h,s,r,d,u),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var xo=class extends Vn{constructor(t,e,n,s=1){super(t,e,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},so=new Ae,Vm=new Ae,Dl=[],Gm=new Ji,Ry=new Ae,ea=new Hn,na=new Ss,ma=class extends Hn{constructor(t,e,n){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new xo(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Ry)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Ji),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,so),Gm.copy(t.boundingBox).applyMatrix4(so),this.boundingBox.union(Gm)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new Ss),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,so),na.copy(t.boundingSphere).applyMatrix4(so),this.boundingSphere.union(na)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let n=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=t*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(t,e){let n=this.matrixWorld,s=this.count;if(ea.geometry=this.geometry,ea.material=this.material,ea.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),na.copy(this.boundingSphere),na.applyMatrix4(n),t.ray.intersectsSphere(na)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,so),Vm.multiplyMatrices(n,so),ea.matrixWorld=Vm,ea.raycast(t,Dl);for(let o=0,a=Dl.length;o<a;o++){let c=Dl[o];c.instanceId=r,c.object=this,e.push(c)}Dl.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new xo(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let n=e.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new gr(new Float32Array(s*this.count),s,this.count,Pc,wi));let r=this.morphTexture.source.data.data,o=0;for(let l=0;l<n.length;l++)o+=n[l];let a=this.geometry.morphTargetsRelative?1:1-o,c=s*t;return r[c]=a,r.set(n,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},pr=new Ss,Cy=new ee(.5,.5),Nl=new q,Xs=class{constructor(t=new pi,e=new pi,n=new pi,s=new pi,r=new pi,o=new pi){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=bi,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],c=r[2],l=r[3],h=r[4],d=r[5],u=r[6],f=r[7],p=r[8],y=r[9],m=r[10],g=r[11],v=r[12],A=r[13],S=r[14],C=r[15];if(s[0].setComponents(l-o,f-h,g-p,C-v).normalize(),s[1].setComponents(l+o,f+h,g+p,C+v).normalize(),s[2].setComponents(l+a,f+d,g+y,C+A).normalize(),s[3].setComponents(l-a,f-d,g-y,C-A).normalize(),n)s[4].setComponents(c,u,m,S).normalize(),s[5].setComponents(l-c,f-u,g-m,C-S).normalize();else if(s[4].setComponents(l-c,f-u,g-m,C-S).normalize(),e===bi)s[5].setComponents(l+c,f+u,g+m,C+S).normalize();else if(e===uo)s[5].setComponents(c,u,m,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),pr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),pr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(pr)}intersectsSprite(t){pr.center.set(0,0,0);let e=Cy.distanceTo(t.center);return pr.radius=.7071067811865476+e,pr.applyMatrix4(t.matrixWorld),this.intersectsSphere(pr)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(Nl.x=s.normal.x>0?t.max.x:t.min.x,Nl.y=s.normal.y>0?t.max.y:t.min.y,Nl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Nl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Hm=new Ae,sc=class i{constructor(){this.coordinateSystem=bi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Hm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Xs),n[s].setFromProjectionMatrix(Hm,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Xs),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var vo=class extends Ms{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new fe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},rc=new q,oc=new q,Wm=new Ae,ia=new mr,Ul=new Ss,qu=new q,Xm=new q,ac=class extends Gn{constructor(t=new Dn,e=new vo){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)rc.fromBufferAttribute(e,s-1),oc.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=rc.distanceTo(oc);t.setAttribute("lineDistance",new xn(n,1))}else Zt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Ul.copy(n.boundingSphere),Ul.applyMatrix4(s),Ul.radius+=r,t.ray.intersectsSphere(Ul)===!1)return;Wm.copy(s).invert(),ia.copy(t.ray).applyMatrix4(Wm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,h=n.index,u=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let y=f,m=p-1;y<m;y+=l){let g=h.getX(y),v=h.getX(y+1),A=Fl(this,t,ia,c,g,v,y);A&&e.push(A)}if(this.isLineLoop){let y=h.getX(p-1),m=h.getX(f),g=Fl(this,t,ia,c,y,m,p-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let y=f,m=p-1;y<m;y+=l){let g=Fl(this,t,ia,c,y,y+1,y);g&&e.push(g)}if(this.isLineLoop){let y=Fl(this,t,ia,c,p-1,f,p-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Fl(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(rc.fromBufferAttribute(a,s),oc.fromBufferAttribute(a,r),e.distanceSqToSegment(rc,oc,qu,Xm)>n)return;qu.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(qu);if(!(l<t.near||l>t.far))return{distance:l,point:Xm.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var qm=new q,Ym=new q,ga=class extends ac{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)qm.fromBufferAttribute(e,s),Ym.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+qm.distanceTo(Ym);t.setAttribute("lineDistance",new xn(n,1))}else Zt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var _a=class extends ei{constructor(t=[],e=Sr,n,s,r,o,a,c,l,h){super(t,e,n,s,r,o,a,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var bs=class extends ei{constructor(t,e,n=Fi,s,r,o,a=Pn,c=Pn,l,h=vs,d=1){if(h!==vs&&h!==Ts)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:t,height:e,depth:d};super(u,s,r,o,a,c,h,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new mo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},xa=class extends bs{constructor(t,e=Fi,n=Sr,s,r,o=Pn,a=Pn,c,l=vs){let h={width:t,height:t,depth:1},d=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,c,l),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},va=class extends ei{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},qs=class i extends Dn{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],h=[],d=[],u=0,f=0;p("z","y","x",-1,-1,n,e,t,o,r,0),p("z","y","x",1,-1,n,e,-t,o,r,1),p("x","z","y",1,1,t,n,e,s,o,2),p("x","z","y",1,-1,t,n,-e,s,o,3),p("x","y","z",1,-1,t,e,n,s,r,4),p("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(c),this.setAttribute("position",new xn(l,3)),this.setAttribute("normal",new xn(h,3)),this.setAttribute("uv",new xn(d,2));function p(y,m,g,v,A,S,C,M,_,b,N){let R=S/_,P=C/b,O=S/2,z=C/2,D=M/2,H=_+1,W=b+1,V=0,ht=0,J=new q;for(let k=0;k<W;k++){let Q=k*P-z;for(let lt=0;lt<H;lt++){let ot=lt*R-O;J[y]=ot*v,J[m]=Q*A,J[g]=D,l.push(J.x,J.y,J.z),J[y]=0,J[m]=0,J[g]=M>0?1:-1,h.push(J.x,J.y,J.z),d.push(lt/_),d.push(1-k/b),V+=1}}for(let k=0;k<b;k++)for(let Q=0;Q<_;Q++){let lt=u+Q+H*k,ot=u+Q+H*(k+1),K=u+(Q+1)+H*(k+1),ut=u+(Q+1)+H*k;c.push(lt,ot,ut),c.push(ot,K,ut),ht+=6}a.addGroup(f,ht,N),f+=ht,u+=V}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var yo=class i extends Dn{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let h=[],d=[],u=[],f=[],p=0,y=[],m=n/2,g=0;v(),o===!1&&(t>0&&A(!0),e>0&&A(!1)),this.setIndex(h),this.setAttribute("position",new xn(d,3)),this.setAttribute("normal",new xn(u,3)),this.setAttribute("uv",new xn(f,2));function v(){let S=new q,C=new q,M=0,_=(e-t)/n;for(let b=0;b<=r;b++){let N=[],R=b/r,P=R*(e-t)+t;for(let O=0;O<=s;O++){let z=O/s,D=z*c+a,H=Math.sin(D),W=Math.cos(D);C.x=P*H,C.y=-R*n+m,C.z=P*W,d.push(C.x,C.y,C.z),S.set(H,_,W).normalize(),u.push(S.x,S.y,S.z),f.push(z,1-R),N.push(p++)}y.push(N)}for(let b=0;b<s;b++)for(let N=0;N<r;N++){let R=y[N][b],P=y[N+1][b],O=y[N+1][b+1],z=y[N][b+1];(t>0||N!==0)&&(h.push(R,P,z),M+=3),(e>0||N!==r-1)&&(h.push(P,O,z),M+=3)}l.addGroup(g,M,0),g+=M}function A(S){let C=p,M=new ee,_=new q,b=0,N=S===!0?t:e,R=S===!0?1:-1;for(let O=1;O<=s;O++)d.push(0,m*R,0),u.push(0,R,0),f.push(.5,.5),p++;let P=p;for(let O=0;O<=s;O++){let D=O/s*c+a,H=Math.cos(D),W=Math.sin(D);_.x=N*W,_.y=m*R,_.z=N*H,d.push(_.x,_.y,_.z),u.push(0,R,0),M.x=H*.5+.5,M.y=W*.5*R+.5,f.push(M.x,M.y),p++}for(let O=0;O<s;O++){let z=C+O,D=P+O;S===!0?h.push(D,D+1,z):h.push(D+1,D,z),b+=3}l.addGroup(g,b,S===!0?1:2),g+=b}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},ya=class i extends yo{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var Ol=new q,Bl=new q,Yu=new q,kl=new gs,Sa=class extends Dn{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(lo*e),o=t.getIndex(),a=t.getAttribute("position"),c=o?o.count:a.count,l=[0,0,0],h=["a","b","c"],d=new Array(3),u=new Map,f=[];for(let p=0;p<c;p+=3){o?(l[0]=o.getX(p),l[1]=o.getX(p+1),l[2]=o.getX(p+2)):(l[0]=p,l[1]=p+1,l[2]=p+2);let{a:y,b:m,c:g}=kl;if(y.fromBufferAttribute(a,l[0]),m.fromBufferAttribute(a,l[1]),g.fromBufferAttribute(a,l[2]),kl.getNormal(Yu),d[0]=`${Math.round(y.x*s)},${Math.round(y.y*s)},${Math.round(y.z*s)}`,d[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,d[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(d[0]===d[1]||d[1]===d[2]||d[2]===d[0]))for(let v=0;v<3;v++){let A=(v+1)%3,S=d[v],C=d[A],M=kl[h[v]],_=kl[h[A]],b=`${S}_${C}`,N=`${C}_${S}`,R=u.get(N);R?(Yu.dot(R.normal)<=r&&(f.push(M.x,M.y,M.z),f.push(_.x,_.y,_.z)),u.set(N,null)):u.has(b)||u.set(b,{index0:l[v],index1:l[A],normal:Yu.clone()})}}for(let p of u.values())if(p){let{index0:y,index1:m}=p;Ol.fromBufferAttribute(a,y),Bl.fromBufferAttribute(a,m),f.push(Ol.x,Ol.y,Ol.z),f.push(Bl.x,Bl.y,Bl.z)}this.setAttribute("position",new xn(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var _r=class i extends Dn{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),c=Math.floor(s),l=a+1,h=c+1,d=t/a,u=e/c,f=[],p=[],y=[],m=[];for(let g=0;g<h;g++){let v=g*u-o;for(let A=0;A<l;A++){let S=A*d-r;p.push(S,-v,0),y.push(0,0,1),m.push(A/a),m.push(1-g/c)}}for(let g=0;g<c;g++)for(let v=0;v<a;v++){let A=v+l*g,S=v+l*(g+1),C=v+1+l*(g+1),M=v+1+l*g;f.push(A,S,M),f.push(S,C,M)}this.setIndex(f),this.setAttribute("position",new xn(p,3)),this.setAttribute("normal",new xn(y,3)),this.setAttribute("uv",new xn(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};function br(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if($m(s))s.isRenderTargetTexture?(Zt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if($m(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Wn(i){let t={};for(let e=0;e<i.length;e++){let n=br(i[e]);for(let s in n)t[s]=n[s]}return t}function $m(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Py(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Pd(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ye.workingColorSpace}var Vg={clone:br,merge:Wn},Iy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Ly=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ki=class extends Ms{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Iy,this.fragmentShader=Ly,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=br(t.uniforms),this.uniformsGroups=Py(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new fe().setHex(s.value);break;case"v2":this.uniforms[n].value=new ee().fromArray(s.value);break;case"v3":this.uniforms[n].value=new q().fromArray(s.value);break;case"v4":this.uniforms[n].value=new $e().fromArray(s.value);break;case"m3":this.uniforms[n].value=new re().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Ae().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},lc=class extends Ki{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var xr=class extends Ms{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new fe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new fe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=hh,this.normalScale=new ee(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ys,this.combine=bc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},cc=class extends Ms{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Tg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},hc=class extends Ms{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function ro(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function zl(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Ys=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},uc=class extends Ys{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ju,endingEnd:Ju}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Ku:r=t,a=2*e-n;break;case ju:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(c===void 0)switch(this.getSettings_().endingEnd){case Ku:o=t,c=2*n-e;break;case ju:o=1,c=n+s[1]-s[0];break;default:o=t-1,c=e}let l=(n-e)*.5,h=this.valueSize;this._weightPrev=l/(e-a),this._weightNext=l/(c-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,f=this._weightNext,p=(n-e)/(s-e),y=p*p,m=y*p,g=-u*m+2*u*y-u*p,v=(1+u)*m+(-1.5-2*u)*y+(-.5+u)*p+1,A=(-1-f)*m+(1.5+f)*y+.5*p,S=f*m-f*y;for(let C=0;C!==a;++C)r[C]=g*o[h+C]+v*o[l+C]+A*o[c+C]+S*o[d+C];return r}},dc=class extends Ys{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=(n-e)/(s-e),d=1-h;for(let u=0;u!==a;++u)r[u]=o[l+u]*d+o[c+u]*h;return r}},fc=class extends Ys{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},pc=class extends Ys{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this.inTangents,d=this.outTangents;if(!h||!d){let p=(n-e)/(s-e),y=1-p;for(let m=0;m!==a;++m)r[m]=o[l+m]*y+o[c+m]*p;return r}let u=a*2,f=t-1;for(let p=0;p!==a;++p){let y=o[l+p],m=o[c+p],g=f*u+p*2,v=d[g],A=d[g+1],S=t*u+p*2,C=h[S],M=h[S+1],_=Ny(n,e,v,C,s);r[p]=Gg(_,y,A,M,m)}return r}};function Gg(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function Dy(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function Ny(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=Gg(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let c=Dy(r,t,e,n,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var gi=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=ro(e,this.TimeBufferType),this.values=ro(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:ro(t.times,Array),values:ro(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),zl(t.settings)&&(n.settings={inTangents:ro(t.settings.inTangents,Array),outTangents:ro(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new fc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new dc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new uc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new pc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case oa:e=this.InterpolantFactoryMethodDiscrete;break;case tc:e=this.InterpolantFactoryMethodLinear;break;case Hl:e=this.InterpolantFactoryMethodSmooth;break;case Zu:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Zt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return oa;case this.InterpolantFactoryMethodLinear:return tc;case this.InterpolantFactoryMethodSmooth:return Hl;case this.InterpolantFactoryMethodBezier:return Zu}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;zl(this.settings)&&(Zm(this.settings.inTangents,t),Zm(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;zl(this.settings)&&(Jm(this.settings.inTangents,t),Jm(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(se("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(se("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let c=n[a];if(typeof c=="number"&&isNaN(c)){se("KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){se("KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(s!==void 0&&Zv(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){se("KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Hl,r=t.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=t[a],h=t[a+1];if(l!==h&&(a!==1||l!==t[0]))if(s)c=!0;else{let d=a*n,u=d-n,f=d+n;for(let p=0;p!==n;++p){let y=e[d+p];if(y!==e[u+p]||y!==e[f+p]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let d=a*n,u=o*n;for(let f=0;f!==n;++f)e[u+f]=e[d+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,c=o*n,l=0;l!==n;++l)e[c+l]=e[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,zl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Zm(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function Jm(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}gi.prototype.ValueTypeName="";gi.prototype.TimeBufferType=Float32Array;gi.prototype.ValueBufferType=Float32Array;gi.prototype.DefaultInterpolation=tc;var $s=class extends gi{constructor(t,e,n){super(t,e,n)}};$s.prototype.ValueTypeName="bool";$s.prototype.ValueBufferType=Array;$s.prototype.DefaultInterpolation=oa;$s.prototype.InterpolantFactoryMethodLinear=void 0;$s.prototype.InterpolantFactoryMethodSmooth=void 0;var mc=class extends gi{constructor(t,e,n,s){super(t,e,n,s)}};mc.prototype.ValueTypeName="color";var gc=class extends gi{constructor(t,e,n,s){super(t,e,n,s)}};gc.prototype.ValueTypeName="number";var _c=class extends Ys{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(n-e)/(s-e),l=t*a;for(let h=l+a;l!==h;l+=4)Qn.slerpFlat(r,0,o,l-a,o,l,c);return r}},Ma=class extends gi{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new _c(this.times,this.values,this.getValueSize(),t)}};Ma.prototype.ValueTypeName="quaternion";Ma.prototype.InterpolantFactoryMethodSmooth=void 0;var Zs=class extends gi{constructor(t,e,n){super(t,e,n)}};Zs.prototype.ValueTypeName="string";Zs.prototype.ValueBufferType=Array;Zs.prototype.DefaultInterpolation=oa;Zs.prototype.InterpolantFactoryMethodLinear=void 0;Zs.prototype.InterpolantFactoryMethodSmooth=void 0;var xc=class extends gi{constructor(t,e,n,s){super(t,e,n,s)}};xc.prototype.ValueTypeName="vector";var vc=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,d){return l.push(h,d),this},this.removeHandler=function(h){let d=l.indexOf(h);return d!==-1&&l.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=l.length;d<u;d+=2){let f=l[d],p=l[d+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Hg=new vc,yc=class{constructor(t){this.manager=t!==void 0?t:Hg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};yc.DEFAULT_MATERIAL_NAME="__DEFAULT";var ba=class extends Gn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new fe(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var $u=new Ae,Km=new q,jm=new q,Sc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ee(512,512),this.mapType=ii,this.map=null,this.mapPass=null,this.matrix=new Ae,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Xs,this._frameExtents=new ee(1,1),this._viewportCount=1,this._viewports=[new $e(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Km.setFromMatrixPosition(t.matrixWorld),e.position.copy(Km),jm.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(jm),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){$u.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix($u,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;t.coordinateSystem===uo||t.reversedDepth?e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),e.multiply($u)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Vl=new q,Gl=new Qn,$i=new q,wa=class extends Gn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ae,this.projectionMatrix=new Ae,this.projectionMatrixInverse=new Ae,this.coordinateSystem=bi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Vl,Gl,$i),$i.x===1&&$i.y===1&&$i.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Vl,Gl,$i.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(Vl,Gl,$i),$i.x===1&&$i.y===1&&$i.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Vl,Gl,$i.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ws=new q,Qm=new ee,tg=new ee,jn=class extends wa{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=po*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(lo*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return po*2*Math.atan(Math.tan(lo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Ws.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Ws.x,Ws.y).multiplyScalar(-t/Ws.z),Ws.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ws.x,Ws.y).multiplyScalar(-t/Ws.z)}getViewSize(t,e){return this.getViewBounds(t,Qm,tg),e.subVectors(tg,Qm)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(lo*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,e-=o.offsetY*n/l,s*=o.width/c,n*=o.height/l}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Ta=class extends wa{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=h*this.view.offsetY,c=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Qu=class extends Sc{constructor(){super(new Ta(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ea=class extends ba{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Gn.DEFAULT_UP),this.updateMatrix(),this.target=new Gn,this.shadow=new Qu}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},Aa=class extends ba{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var oo=-90,ao=1,So=class extends Gn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new jn(oo,ao,t,e);s.layers=this.layers,this.add(s);let r=new jn(oo,ao,t,e);r.layers=this.layers,this.add(r);let o=new jn(oo,ao,t,e);o.layers=this.layers,this.add(o);let a=new jn(oo,ao,t,e);a.layers=this.layers,this.add(a);let c=new jn(oo,ao,t,e);c.layers=this.layers,this.add(c);let l=new jn(oo,ao,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,c]=e;for(let l of e)this.remove(l);if(t===bi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===uo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,h]=this.children,d=t.getRenderTarget(),u=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(n,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),n.texture.mipmapsAutoUpdate=y,t.setRenderTarget(n,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(d,u,f),t.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Mc=class extends jn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Id="\\[\\]\\.:\\/",Uy=new RegExp("["+Id+"]","g"),Ld="[^"+Id+"]",Fy="[^"+Id.replace("\\.","")+"]",Oy=/((?:WC+[\/:])*)/.source.replace("WC",Ld),By=/(WCOD+)?/.source.replace("WCOD",Fy),ky=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Ld),zy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Ld),Vy=new RegExp("^"+Oy+By+ky+zy+"$"),Gy=["material","materials","bones","map"],td=class{constructor(t,e,n){let s=n||qe.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},qe=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Uy,"")}static parseTrackName(t){let e=Vy.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Gy.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let c=n(a.children);if(c)return c}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Zt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=e.objectIndex;switch(n){case"materials":if(!t.material){se("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){se("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){se("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===l){l=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){se("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){se("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){se("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(l!==void 0){if(t[l]===void 0){se("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[s];if(o===void 0){let l=e.nodeName;se("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){se("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){se("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qe.Composite=td;qe.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qe.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qe.prototype.GetterByBindingType=[qe.prototype._getValue_direct,qe.prototype._getValue_array,qe.prototype._getValue_arrayElement,qe.prototype._getValue_toArray];qe.prototype.SetterByBindingTypeAndVersioning=[[qe.prototype._setValue_direct,qe.prototype._setValue_direct_setNeedsUpdate,qe.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qe.prototype._setValue_array,qe.prototype._setValue_array_setNeedsUpdate,qe.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qe.prototype._setValue_arrayElement,qe.prototype._setValue_arrayElement_setNeedsUpdate,qe.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qe.prototype._setValue_fromArray,qe.prototype._setValue_fromArray_setNeedsUpdate,qe.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var BE=new Float32Array(1);var Mo=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ge(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(ge(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var ed=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var Ra=class extends Ui{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Dd(i,t,e,n){let s=Hy(n);switch(e){case yd:return i*t;case Pc:return i*t/s.components*s.byteLength;case Ic:return i*t/s.components*s.byteLength;case Qs:return i*t*2/s.components*s.byteLength;case Lc:return i*t*2/s.components*s.byteLength;case Sd:return i*t*3/s.components*s.byteLength;case _i:return i*t*4/s.components*s.byteLength;case Dc:return i*t*4/s.components*s.byteLength;case Ia:case La:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Da:case Na:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Uc:case Oc:return Math.max(i,16)*Math.max(t,8)/4;case Nc:case Fc:return Math.max(i,8)*Math.max(t,8)/2;case Bc:case kc:case Vc:case Gc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case zc:case Ua:case Hc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Wc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Xc:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case qc:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Yc:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case $c:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Zc:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Jc:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Kc:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case jc:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Qc:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case th:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case eh:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case nh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case ih:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case sh:case rh:case oh:return Math.ceil(i/4)*Math.ceil(t/4)*16;case ah:case lh:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Fa:case ch:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Hy(i){switch(i){case ii:case gd:return{byteLength:1,components:1};case Eo:case _d:case Oi:return{byteLength:2,components:1};case Rc:case Cc:return{byteLength:2,components:4};case Fi:case Ac:case wi:return{byteLength:4,components:1};case xd:case vd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Zt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function u0(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function Jy(i){let t=new WeakMap;function e(a,c){let l=a.array,h=a.usage,d=l.byteLength,u=i.createBuffer();i.bindBuffer(c,u),i.bufferData(c,l,h),a.onUploadCallback();let f;if(l instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)f=i.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(l instanceof Int16Array)f=i.SHORT;else if(l instanceof Uint32Array)f=i.UNSIGNED_INT;else if(l instanceof Int32Array)f=i.INT;else if(l instanceof Int8Array)f=i.BYTE;else if(l instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:u,type:f,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:d}}function n(a,c,l){let h=c.array,d=c.updateRanges;if(i.bindBuffer(l,a),d.length===0)i.bufferSubData(l,0,h);else{d.sort((f,p)=>f.start-p.start);let u=0;for(let f=1;f<d.length;f++){let p=d[u],y=d[f];y.start<=p.start+p.count+1?p.count=Math.max(p.count,y.start+y.count-p.start):(++u,d[u]=y)}d.length=u+1;for(let f=0,p=d.length;f<p;f++){let y=d[f];i.bufferSubData(l,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=t.get(a);c&&(i.deleteBuffer(c.buffer),t.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=t.get(a);if(l===void 0)t.set(a,e(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var Ky=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,jy=`#ifdef USE_ALPHAHASH
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
#endif`,Qy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,tS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,eS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,nS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,iS=`#ifdef USE_AOMAP
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
#endif`,sS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,rS=`#ifdef USE_BATCHING
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
#endif`,oS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,aS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,lS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,cS=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,hS=`#ifdef USE_IRIDESCENCE
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
#endif`,uS=`#ifdef USE_BUMPMAP
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
#endif`,dS=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,fS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,pS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,mS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,gS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,_S=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,xS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,vS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,yS=`#define PI 3.141592653589793
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
} // validated`,SS=`vec3 transformedNormal = objectNormal;
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
#endif`,MS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,bS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,wS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,TS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,ES="gl_FragColor = linearToOutputTexel( gl_FragColor );",AS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,RS=`#ifdef USE_ENVMAP
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
#endif`,CS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,PS=`#ifdef USE_ENVMAP
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
#endif`,IS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,LS=`#ifdef USE_ENVMAP
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
#endif`,DS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,NS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,US=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,FS=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,OS=`#ifdef USE_GRADIENTMAP
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
}`,BS=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,kS=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,zS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,VS=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,GS=`#ifdef USE_ENVMAP
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
#endif`,HS=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,WS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,XS=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,qS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,YS=`PhysicalMaterial material;
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
#endif`,$S=`uniform sampler2D dfgLUT;
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
}`,ZS=`
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
#endif`,JS=`#if defined( RE_IndirectDiffuse )
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
#endif`,KS=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,jS=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,QS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,tM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,eM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,nM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,iM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,sM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,rM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,oM=`#if defined( USE_POINTS_UV )
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
#endif`,aM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,lM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,cM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,hM=`#if defined( USE_MORPHCOLORS )
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
#endif`,uM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,dM=`#ifdef USE_MORPHTARGETS
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
#endif`,fM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,pM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,mM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,gM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,_M=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,xM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,vM=`#ifdef USE_NORMALMAP
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
#endif`,yM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,SM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,MM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,bM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,wM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,TM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,EM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,AM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,RM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,CM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,PM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,IM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,LM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,DM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,NM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,UM=`float getShadowMask() {
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
}`,FM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,OM=`#ifdef USE_SKINNING
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
#endif`,BM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,kM=`#ifdef USE_SKINNING
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
#endif`,zM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,VM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,GM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,HM=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,WM=`#ifdef USE_TRANSMISSION
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
#endif`,XM=`#ifdef USE_TRANSMISSION
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
#endif`,qM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,YM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,$M=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,ZM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,JM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,KM=`uniform sampler2D t2D;
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
}`,jM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,QM=`uniform float backgroundBlurriness;
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
}`,tb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,eb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,nb=`#include <common>
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
}`,ib=`#if DEPTH_PACKING == 3200
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
}`,sb=`#define DISTANCE
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
}`,rb=`#define DISTANCE
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
}`,ob=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,ab=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,lb=`uniform float scale;
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
}`,cb=`uniform vec3 diffuse;
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
}`,hb=`#include <common>
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
}`,ub=`uniform vec3 diffuse;
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
}`,db=`#define LAMBERT
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
}`,fb=`#define LAMBERT
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
}`,pb=`#define MATCAP
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
}`,mb=`#define MATCAP
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
}`,gb=`#define NORMAL
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
}`,_b=`#define NORMAL
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
}`,xb=`#define PHONG
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
}`,vb=`#define PHONG
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
}`,yb=`#define STANDARD
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
}`,Sb=`#define STANDARD
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
}`,Mb=`#define TOON
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
}`,bb=`#define TOON
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
}`,wb=`uniform float size;
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
}`,Tb=`uniform vec3 diffuse;
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
}`,Eb=`#include <common>
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
}`,Ab=`uniform vec3 color;
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
}`,Rb=`uniform float rotation;
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
}`,Cb=`uniform vec3 diffuse;
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
}`,de={alphahash_fragment:Ky,alphahash_pars_fragment:jy,alphamap_fragment:Qy,alphamap_pars_fragment:tS,alphatest_fragment:eS,alphatest_pars_fragment:nS,aomap_fragment:iS,aomap_pars_fragment:sS,batching_pars_vertex:rS,batching_vertex:oS,begin_vertex:aS,beginnormal_vertex:lS,bsdfs:cS,iridescence_fragment:hS,bumpmap_pars_fragment:uS,clipping_planes_fragment:dS,clipping_planes_pars_fragment:fS,clipping_planes_pars_vertex:pS,clipping_planes_vertex:mS,color_fragment:gS,color_pars_fragment:_S,color_pars_vertex:xS,color_vertex:vS,common:yS,defaultnormal_vertex:SS,displacementmap_pars_vertex:MS,displacementmap_vertex:bS,emissivemap_fragment:wS,emissivemap_pars_fragment:TS,colorspace_fragment:ES,colorspace_pars_fragment:AS,envmap_fragment:RS,envmap_common_pars_fragment:CS,envmap_pars_fragment:PS,envmap_pars_vertex:IS,envmap_physical_pars_fragment:GS,envmap_vertex:LS,fog_vertex:DS,fog_pars_vertex:NS,fog_fragment:US,fog_pars_fragment:FS,gradientmap_pars_fragment:OS,lightmap_pars_fragment:BS,lights_lambert_fragment:kS,lights_lambert_pars_fragment:zS,lights_pars_begin:VS,lights_toon_fragment:HS,lights_toon_pars_fragment:WS,lights_phong_fragment:XS,lights_phong_pars_fragment:qS,lights_physical_fragment:YS,lights_physical_pars_fragment:$S,lights_fragment_begin:ZS,lights_fragment_maps:JS,lights_fragment_end:KS,lightprobes_pars_fragment:jS,logdepthbuf_fragment:QS,logdepthbuf_pars_fragment:tM,logdepthbuf_pars_vertex:eM,logdepthbuf_vertex:nM,map_fragment:iM,map_pars_fragment:sM,map_particle_fragment:rM,map_particle_pars_fragment:oM,metalnessmap_fragment:aM,metalnessmap_pars_fragment:lM,morphinstance_vertex:cM,morphcolor_vertex:hM,morphnormal_vertex:uM,morphtarget_pars_vertex:dM,morphtarget_vertex:fM,normal_fragment_begin:pM,normal_fragment_maps:mM,normal_pars_fragment:gM,normal_pars_vertex:_M,normal_vertex:xM,normalmap_pars_fragment:vM,clearcoat_normal_fragment_begin:yM,clearcoat_normal_fragment_maps:SM,clearcoat_pars_fragment:MM,iridescence_pars_fragment:bM,opaque_fragment:wM,packing:TM,premultiplied_alpha_fragment:EM,project_vertex:AM,dithering_fragment:RM,dithering_pars_fragment:CM,roughnessmap_fragment:PM,roughnessmap_pars_fragment:IM,shadowmap_pars_fragment:LM,shadowmap_pars_vertex:DM,shadowmap_vertex:NM,shadowmask_pars_fragment:UM,skinbase_vertex:FM,skinning_pars_vertex:OM,skinning_vertex:BM,skinnormal_vertex:kM,specularmap_fragment:zM,specularmap_pars_fragment:VM,tonemapping_fragment:GM,tonemapping_pars_fragment:HM,transmission_fragment:WM,transmission_pars_fragment:XM,uv_pars_fragment:qM,uv_pars_vertex:YM,uv_vertex:$M,worldpos_vertex:ZM,background_vert:JM,background_frag:KM,backgroundCube_vert:jM,backgroundCube_frag:QM,cube_vert:tb,cube_frag:eb,depth_vert:nb,depth_frag:ib,distance_vert:sb,distance_frag:rb,equirect_vert:ob,equirect_frag:ab,linedashed_vert:lb,linedashed_frag:cb,meshbasic_vert:hb,meshbasic_frag:ub,meshlambert_vert:db,meshlambert_frag:fb,meshmatcap_vert:pb,meshmatcap_frag:mb,meshnormal_vert:gb,meshnormal_frag:_b,meshphong_vert:xb,meshphong_frag:vb,meshphysical_vert:yb,meshphysical_frag:Sb,meshtoon_vert:Mb,meshtoon_frag:bb,points_vert:wb,points_frag:Tb,shadow_vert:Eb,shadow_frag:Ab,sprite_vert:Rb,sprite_frag:Cb},Lt={common:{diffuse:{value:new fe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new re},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new re}},envmap:{envMap:{value:null},envMapRotation:{value:new re},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new re}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new re}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new re},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new re},normalScale:{value:new ee(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new re},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new re}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new re}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new re}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new fe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new fe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0},uvTransform:{value:new re}},sprite:{diffuse:{value:new fe(16777215)},opacity:{value:1},center:{value:new ee(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new re},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0}}},ts={basic:{uniforms:Wn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.fog]),vertexShader:de.meshbasic_vert,fragmentShader:de.meshbasic_frag},lambert:{uniforms:Wn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new fe(0)},envMapIntensity:{value:1}}]),vertexShader:de.meshlambert_vert,fragmentShader:de.meshlambert_frag},phong:{uniforms:Wn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new fe(0)},specular:{value:new fe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:de.meshphong_vert,fragmentShader:de.meshphong_frag},standard:{uniforms:Wn([Lt.common,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.roughnessmap,Lt.metalnessmap,Lt.fog,Lt.lights,{emissive:{value:new fe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:de.meshphysical_vert,fragmentShader:de.meshphysical_frag},toon:{uniforms:Wn([Lt.common,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.gradientmap,Lt.fog,Lt.lights,{emissive:{value:new fe(0)}}]),vertexShader:de.meshtoon_vert,fragmentShader:de.meshtoon_frag},matcap:{uniforms:Wn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,{matcap:{value:null}}]),vertexShader:de.meshmatcap_vert,fragmentShader:de.meshmatcap_frag},points:{uniforms:Wn([Lt.points,Lt.fog]),vertexShader:de.points_vert,fragmentShader:de.points_frag},dashed:{uniforms:Wn([Lt.common,Lt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:de.linedashed_vert,fragmentShader:de.linedashed_frag},depth:{uniforms:Wn([Lt.common,Lt.displacementmap]),vertexShader:de.depth_vert,fragmentShader:de.depth_frag},normal:{uniforms:Wn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,{opacity:{value:1}}]),vertexShader:de.meshnormal_vert,fragmentShader:de.meshnormal_frag},sprite:{uniforms:Wn([Lt.sprite,Lt.fog]),vertexShader:de.sprite_vert,fragmentShader:de.sprite_frag},background:{uniforms:{uvTransform:{value:new re},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:de.background_vert,fragmentShader:de.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new re}},vertexShader:de.backgroundCube_vert,fragmentShader:de.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:de.cube_vert,fragmentShader:de.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:de.equirect_vert,fragmentShader:de.equirect_frag},distance:{uniforms:Wn([Lt.common,Lt.displacementmap,{referencePosition:{value:new q},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:de.distance_vert,fragmentShader:de.distance_frag},shadow:{uniforms:Wn([Lt.lights,Lt.fog,{color:{value:new fe(0)},opacity:{value:1}}]),vertexShader:de.shadow_vert,fragmentShader:de.shadow_frag}};ts.physical={uniforms:Wn([ts.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new re},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new re},clearcoatNormalScale:{value:new ee(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new re},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new re},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new re},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new re},sheen:{value:0},sheenColor:{value:new fe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new re},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new re},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new re},transmissionSamplerSize:{value:new ee},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new re},attenuationDistance:{value:0},attenuationColor:{value:new fe(0)},specularColor:{value:new fe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new re},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new re},anisotropyVector:{value:new ee},anisotropyMap:{value:null},anisotropyMapTransform:{value:new re}}]),vertexShader:de.meshphysical_vert,fragmentShader:de.meshphysical_frag};var fh={r:0,b:0,g:0},Pb=new Ae,d0=new re;d0.set(-1,0,0,0,1,0,0,0,1);function Ib(i,t,e,n,s,r){let o=new fe(0),a=s===!0?0:1,c,l,h=null,d=0,u=null;function f(v){let A=v.isScene===!0?v.background:null;if(A&&A.isTexture){let S=v.backgroundBlurriness>0;A=t.get(A,S)}return A}function p(v){let A=!1,S=f(v);S===null?m(o,a):S&&S.isColor&&(m(S,1),A=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(v,A){let S=f(A);S&&S.isCubeTexture?(l===void 0&&(l=new Hn(new qs(1,1,1),new Ki({name:"BackgroundCubeMaterial",uniforms:br(ts.backgroundCube.uniforms),vertexShader:ts.backgroundCube.vertexShader,fragmentShader:ts.backgroundCube.fragmentShader,side:ti,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(C,M,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(l)),l.material.uniforms.envMap.value=S,l.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(Pb.makeRotationFromEuler(A.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(d0),l.material.toneMapped=ye.getTransfer(S.colorSpace)!==Pe,(h!==S||d!==S.version||u!==i.toneMapping)&&(l.material.needsUpdate=!0,h=S,d=S.version,u=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null)):S&&S.isTexture&&(c===void 0&&(c=new Hn(new _r(2,2),new Ki({name:"BackgroundMaterial",uniforms:br(ts.background.uniforms),vertexShader:ts.background.vertexShader,fragmentShader:ts.background.fragmentShader,side:js,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=S,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.toneMapped=ye.getTransfer(S.colorSpace)!==Pe,S.matrixAutoUpdate===!0&&S.updateMatrix(),c.material.uniforms.uvTransform.value.copy(S.matrix),(h!==S||d!==S.version||u!==i.toneMapping)&&(c.material.needsUpdate=!0,h=S,d=S.version,u=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null))}function m(v,A){v.getRGB(fh,Pd(i)),e.buffers.color.setClear(fh.r,fh.g,fh.b,A,r)}function g(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,A=1){o.set(v),a=A,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,m(o,a)},render:p,addToRenderList:y,dispose:g}}function Lb(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=u(null),r=s,o=!1;function a(P,O,z,D,H){let W=!1,V=d(P,D,z,O);r!==V&&(r=V,l(r.object)),W=f(P,D,z,H),W&&p(P,D,z,H),H!==null&&t.update(H,i.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,S(P,O,z,D),H!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(H).buffer))}function c(){return i.createVertexArray()}function l(P){return i.bindVertexArray(P)}function h(P){return i.deleteVertexArray(P)}function d(P,O,z,D){let H=D.wireframe===!0,W=n[O.id];W===void 0&&(W={},n[O.id]=W);let V=P.isInstancedMesh===!0?P.id:0,ht=W[V];ht===void 0&&(ht={},W[V]=ht);let J=ht[z.id];J===void 0&&(J={},ht[z.id]=J);let k=J[H];return k===void 0&&(k=u(c()),J[H]=k),k}function u(P){let O=[],z=[],D=[];for(let H=0;H<e;H++)O[H]=0,z[H]=0,D[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:z,attributeDivisors:D,object:P,attributes:{},index:null}}function f(P,O,z,D){let H=r.attributes,W=O.attributes,V=0,ht=z.getAttributes();for(let J in ht)if(ht[J].location>=0){let Q=H[J],lt=W[J];if(lt===void 0&&(J==="instanceMatrix"&&P.instanceMatrix&&(lt=P.instanceMatrix),J==="instanceColor"&&P.instanceColor&&(lt=P.instanceColor)),Q===void 0||Q.attribute!==lt||lt&&Q.data!==lt.data)return!0;V++}return r.attributesNum!==V||r.index!==D}function p(P,O,z,D){let H={},W=O.attributes,V=0,ht=z.getAttributes();for(let J in ht)if(ht[J].location>=0){let Q=W[J];Q===void 0&&(J==="instanceMatrix"&&P.instanceMatrix&&(Q=P.instanceMatrix),J==="instanceColor"&&P.instanceColor&&(Q=P.instanceColor));let lt={};lt.attribute=Q,Q&&Q.data&&(lt.data=Q.data),H[J]=lt,V++}r.attributes=H,r.attributesNum=V,r.index=D}function y(){let P=r.newAttributes;for(let O=0,z=P.length;O<z;O++)P[O]=0}function m(P){g(P,0)}function g(P,O){let z=r.newAttributes,D=r.enabledAttributes,H=r.attributeDivisors;z[P]=1,D[P]===0&&(i.enableVertexAttribArray(P),D[P]=1),H[P]!==O&&(i.vertexAttribDivisor(P,O),H[P]=O)}function v(){let P=r.newAttributes,O=r.enabledAttributes;for(let z=0,D=O.length;z<D;z++)O[z]!==P[z]&&(i.disableVertexAttribArray(z),O[z]=0)}function A(P,O,z,D,H,W,V){V===!0?i.vertexAttribIPointer(P,O,z,H,W):i.vertexAttribPointer(P,O,z,D,H,W)}function S(P,O,z,D){y();let H=D.attributes,W=z.getAttributes(),V=O.defaultAttributeValues;for(let ht in W){let J=W[ht];if(J.location>=0){let k=H[ht];if(k===void 0&&(ht==="instanceMatrix"&&P.instanceMatrix&&(k=P.instanceMatrix),ht==="instanceColor"&&P.instanceColor&&(k=P.instanceColor)),k!==void 0){let Q=k.normalized,lt=k.itemSize,ot=t.get(k);if(ot===void 0)continue;let K=ot.buffer,ut=ot.type,ft=ot.bytesPerElement,_t=ut===i.INT||ut===i.UNSIGNED_INT||k.gpuType===Ac;if(k.isInterleavedBufferAttribute){let mt=k.data,Bt=mt.isInterleavedBuffer===!0?mt.stride:mt.itemSize,Kt=k.offset;if(mt.isInstancedInterleavedBuffer||mt.isInstancedBufferAttribute){for(let Ft=0;Ft<J.locationSize;Ft++)g(J.location+Ft,mt.meshPerAttribute);P.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=mt.meshPerAttribute*mt.count)}else for(let Ft=0;Ft<J.locationSize;Ft++)m(J.location+Ft);i.bindBuffer(i.ARRAY_BUFFER,K);for(let Ft=0;Ft<J.locationSize;Ft++)A(J.location+Ft,lt/J.locationSize,ut,Q,Bt*ft,(Kt+lt/J.locationSize*Ft)*ft,_t)}else{if(k.isInstancedBufferAttribute){for(let mt=0;mt<J.locationSize;mt++)g(J.location+mt,k.meshPerAttribute);P.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=k.meshPerAttribute*k.count)}else for(let mt=0;mt<J.locationSize;mt++)m(J.location+mt);i.bindBuffer(i.ARRAY_BUFFER,K);for(let mt=0;mt<J.locationSize;mt++)A(J.location+mt,lt/J.locationSize,ut,Q,lt*ft,lt/J.locationSize*mt*ft,_t)}}else if(V!==void 0){let Q=V[ht];if(Q!==void 0)switch(Q.length){case 2:i.vertexAttrib2fv(J.location,Q);break;case 3:i.vertexAttrib3fv(J.location,Q);break;case 4:i.vertexAttrib4fv(J.location,Q);break;default:i.vertexAttrib1fv(J.location,Q)}}}}v()}function C(){N();for(let P in n){let O=n[P];for(let z in O){let D=O[z];for(let H in D){let W=D[H];for(let V in W)h(W[V].object),delete W[V];delete D[H]}}delete n[P]}}function M(P){if(n[P.id]===void 0)return;let O=n[P.id];for(let z in O){let D=O[z];for(let H in D){let W=D[H];for(let V in W)h(W[V].object),delete W[V];delete D[H]}}delete n[P.id]}function _(P){for(let O in n){let z=n[O];for(let D in z){let H=z[D];if(H[P.id]===void 0)continue;let W=H[P.id];for(let V in W)h(W[V].object),delete W[V];delete H[P.id]}}}function b(P){for(let O in n){let z=n[O],D=P.isInstancedMesh===!0?P.id:0,H=z[D];if(H!==void 0){for(let W in H){let V=H[W];for(let ht in V)h(V[ht].object),delete V[ht];delete H[W]}delete z[D],Object.keys(z).length===0&&delete n[O]}}}function N(){R(),o=!0,r!==s&&(r=s,l(r.object))}function R(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:N,resetDefaultState:R,dispose:C,releaseStatesOfGeometry:M,releaseStatesOfObject:b,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:m,disableUnusedAttributes:v}}function Db(i,t,e){let n;function s(c){n=c}function r(c,l){i.drawArrays(n,c,l),e.update(l,n,1)}function o(c,l,h){h!==0&&(i.drawArraysInstanced(n,c,l,h),e.update(l,n,h))}function a(c,l,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,l,0,h);let u=0;for(let f=0;f<h;f++)u+=l[f];e.update(u,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Nb(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==_i&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let b=_===Oi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==ii&&_!==wi&&!b&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function c(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",h=c(l);h!==l&&(Zt("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let d=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=e.logarithmicDepthBuffer===!0&&d===!1;e.reversedDepthBuffer===!0&&d===!1&&Zt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&d===!0&&Zt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),S=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),M=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:p,maxTextureSize:y,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:v,maxVaryings:A,maxFragmentUniforms:S,maxSamples:C,samples:M}}function Ub(i){let t=this,e=null,n=0,s=!1,r=!1,o=new pi,a=new re,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let f=d.length!==0||u||n!==0||s;return s=u,n=d.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){e=h(d,u,0)},this.setState=function(d,u,f){let p=d.clippingPlanes,y=d.clipIntersection,m=d.clipShadows,g=i.get(d);if(!s||p===null||p.length===0||r&&!m)r?h(null):l();else{let v=r?0:n,A=v*4,S=g.clippingState||null;c.value=S,S=h(p,u,A,f);for(let C=0;C!==A;++C)S[C]=e[C];g.clippingState=S,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(d,u,f,p){let y=d!==null?d.length:0,m=null;if(y!==0){if(m=c.value,p!==!0||m===null){let g=f+y*4,v=u.matrixWorldInverse;a.getNormalMatrix(v),(m===null||m.length<g)&&(m=new Float32Array(g));for(let A=0,S=f;A!==y;++A,S+=4)o.copy(d[A]).applyMatrix4(v,a),o.normal.toArray(m,S),m[S+3]=o.constant}c.value=m,c.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,m}}var ka=class extends mi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new _a(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new qs(5,5,5),r=new Ki({name:"CubemapFromEquirect",uniforms:br(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ti,blending:vr});r.uniforms.tEquirect.value=e;let o=new Hn(s,r),a=e.minFilter;return e.minFilter===ws&&(e.minFilter=Ln),new So(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},Wg=256,Fb=3,Ob=20,f0=256,p0=16,Bb=3,kb=new q,zb=new fe,mh=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new So(1,10,null),this._boxMesh=new Hn(new qs(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=kb}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let d=c.autoClear,u=c.autoClearColor,f=c.autoClearDepth,p=c.autoClearStencil,y=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,y===null&&(t.background=c.getClearColor(zb));let m=new So(n,s,h);return m.position.copy(a),m.update(c,t),c.autoClear=d,c.autoClearColor=u,c.autoClearDepth=f,c.autoClearStencil=p,t.background=y,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Yg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=qg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Wg,Rd(t))}_fromTexture(t,e){t.mapping===Sr||t.mapping===To?this._setSize(t.image.length===0?Wg:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=Xg(t,!1,!1),n=Math.log2(t)-Fb;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Xg(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Sr||t.mapping===To?(this._cubemapMaterial===null&&(this._cubemapMaterial=Yg()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=qg()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Vb(),this._integrationMaterial=Gb());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/p0);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-Bb)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let c=a>0?Math.log2(e)+.5*Math.log2(6/(f0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=Hb());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function Xg(i,t,e){return new ka(i,{minFilter:ws,generateMipmaps:t,type:Oi,colorSpace:aa,depthBuffer:e})}function za(i,t,e){return new Ki({name:i,uniforms:t,vertexShader:de.cube_vert,fragmentShader:e,side:ti,blending:vr,depthTest:!1,depthWrite:!1})}function Vb(){return za("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${f0}u

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
	`)}function Gb(){return za("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:p0}},`

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
	`)}function Hb(){return za("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Ob}
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
	`)}function qg(){return za("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Yg(){return za("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Wb(i){let t=new WeakMap,e=new WeakMap,n=null;function s(u,f=!1){return u==null?null:f?o(u):r(u)}function r(u){if(u&&u.isTexture){let f=u.mapping;if(f===wc||f===Tc)if(t.has(u)){let p=t.get(u).texture;return a(p,u.mapping)}else{let p=u.image;if(p&&p.height>0){let y=new ka(p.height);return y.fromEquirectangularTexture(i,u),t.set(u,y),u.addEventListener("dispose",l),a(y.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let f=u.mapping,p=f===wc||f===Tc,y=f===Sr||f===To;if(p||y){let m=e.get(u),g=m!==void 0?m.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==g)return n===null&&(n=new mh(i)),m=p?n.fromEquirectangular(u,m):n.fromCubemap(u,m),m.texture.pmremVersion=u.pmremVersion,e.set(u,m),m.texture;if(m!==void 0)return m.texture;{let v=u.image;return p&&v&&v.height>0||y&&v&&c(v)?(n===null&&(n=new mh(i)),m=p?n.fromEquirectangular(u):n.fromCubemap(u),m.texture.pmremVersion=u.pmremVersion,e.set(u,m),u.addEventListener("dispose",h),m.texture):null}}}return u}function a(u,f){return f===wc?u.mapping=Sr:f===Tc&&(u.mapping=To),u}function c(u){let f=0,p=6;for(let y=0;y<p;y++)u[y]!==void 0&&f++;return f===p}function l(u){let f=u.target;f.removeEventListener("dispose",l);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(u){let f=u.target;f.removeEventListener("dispose",h);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function d(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:d}}function Xb(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&sa("WebGLRenderer: "+n+" extension not supported."),s}}}function qb(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){c(p.target)}function c(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let y=r.get(p);y&&(t.remove(y),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function l(p,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function h(p){let y=p.attributes;for(let m in y)t.update(y[m],i.ARRAY_BUFFER)}function d(p){let y=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let v=y!==null?y.array.length:m.array.length/3-1,A=m.count>=65535?pa:fa,S=new A(Math.ceil(v/3)*6,1),C=S.array;if(y!==null){let _=y.array;g=y.version;for(let b=0,N=0;b<v;b+=3){let R=_[b+0],P=_[b+1],O=_[b+2];C[N++]=R,C[N++]=P,C[N++]=P,C[N++]=O,C[N++]=O,C[N++]=R}}else{g=m.version;for(let _=0,b=0;_<v;_+=3){let N=_+0,R=_+1,P=_+2;C[b++]=N,C[b++]=R,C[b++]=R,C[b++]=P,C[b++]=P,C[b++]=N}}S.version=g;let M=r.get(p);M&&t.remove(M),r.set(p,S)}function u(p){let y=r.get(p);if(y){let m=p.index;m!==null&&y.version<m.version&&d(p)}else d(p);return r.get(p)}function f(){for(let p in s){let y=s[p].deref();y!==void 0&&c(y)}}return{get:l,update:h,getWireframeAttribute:u,dispose:f}}function Yb(i,t,e){let n;function s(d){n=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function c(d,u){i.drawElements(n,u,r,d*o),e.update(u,n,1)}function l(d,u,f){f!==0&&(i.drawElementsInstanced(n,u,r,d*o,f),e.update(u,n,f))}function h(d,u,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,u,0,r,d,0,f);let y=0;for(let m=0;m<f;m++)y+=u[m];e.update(y,n,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function $b(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:se("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function Zb(i,t,e){let n=new WeakMap,s=new $e;function r(o,a,c){let l=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,u=n.get(a);if(u===void 0||u.count!==d){let N=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",N)};u!==void 0&&u.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],A=0;f===!0&&(A=1),p===!0&&(A=2),y===!0&&(A=3);let S=a.attributes.position.count*A,C=1;S>t.maxTextureSize&&(C=Math.ceil(S/t.maxTextureSize),S=t.maxTextureSize);let M=new Float32Array(S*C*4*d),_=new ha(M,S,C,d);_.type=wi,_.needsUpdate=!0;let b=A*4;for(let R=0;R<d;R++){let P=m[R],O=g[R],z=v[R],D=S*C*4*R;for(let H=0;H<P.count;H++){let W=H*b;f===!0&&(s.fromBufferAttribute(P,H),M[D+W+0]=s.x,M[D+W+1]=s.y,M[D+W+2]=s.z,M[D+W+3]=0),p===!0&&(s.fromBufferAttribute(O,H),M[D+W+4]=s.x,M[D+W+5]=s.y,M[D+W+6]=s.z,M[D+W+7]=0),y===!0&&(s.fromBufferAttribute(z,H),M[D+W+8]=s.x,M[D+W+9]=s.y,M[D+W+10]=s.z,M[D+W+11]=z.itemSize===4?s.w:1)}}u={count:d,texture:_,size:new ee(S,C)},n.set(a,u),a.addEventListener("dispose",N)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let f=0;for(let y=0;y<l.length;y++)f+=l[y];let p=a.morphTargetsRelative?1:1-f;c.getUniforms().setValue(i,"morphTargetBaseInfluence",p),c.getUniforms().setValue(i,"morphTargetInfluences",l)}c.getUniforms().setValue(i,"morphTargetsTexture",u.texture,e),c.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:r}}function Jb(i,t,e,n,s){let r=new WeakMap;function o(l){let h=s.render.frame,d=l.geometry,u=t.get(l,d);if(r.get(u)!==h&&(t.update(u),r.set(u,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let f=l.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return u}function a(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var Kb={[ld]:"LINEAR_TONE_MAPPING",[cd]:"REINHARD_TONE_MAPPING",[hd]:"CINEON_TONE_MAPPING",[ud]:"ACES_FILMIC_TONE_MAPPING",[fd]:"AGX_TONE_MAPPING",[pd]:"NEUTRAL_TONE_MAPPING",[dd]:"CUSTOM_TONE_MAPPING"};function jb(i,t,e,n,s,r){let o=new mi(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,h=new Dn;h.setAttribute("position",new xn([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new xn([0,2,0,0,2,0],2));let d=new lc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new Hn(h,d),f=new Ta(-1,1,1,-1,0,1),p=null,y=null,m=!1,g,v=null,A=[],S=!1;this.setSize=function(C,M){o.setSize(C,M),a!==null&&a.setSize(C,M),c!==null&&c.setSize(C,M);for(let _=0;_<A.length;_++){let b=A[_];b.setSize&&b.setSize(C,M)}},this.setEffects=function(C){A=C,S=A.length>0&&A[0].isRenderPass===!0;let M=o.width,_=o.height;A.length>0&&a===null&&(a=new mi(M,_,{type:Oi,depthBuffer:!1,stencilBuffer:!1}),c=new mi(M,_,{type:Oi,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&A.some(N=>N.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&l===null&&(l=new bs(M,_),r===!0&&(l.format=Ts,l.type=Mr)),o.dispose(),o.depthTexture=b?l:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let N=0;N<A.length;N++){let R=A[N];R.setSize&&R.setSize(M,_),b&&R.needsDepthTexture===!0&&R.setDepthTexture&&R.setDepthTexture(l)}},this.begin=function(C,M){if(m||C.toneMapping===ji&&A.length===0)return!1;if(v=M,M!==null){let _=M.width,b=M.height;(o.width!==_||o.height!==b)&&this.setSize(_,b)}return S===!1&&C.setRenderTarget(o),g=C.toneMapping,C.toneMapping=ji,!0},this.hasRenderPass=function(){return S},this.end=function(C,M){C.toneMapping=g,m=!0;let _=o,b=a;for(let N=0;N<A.length;N++){let R=A[N];R.enabled!==!1&&(R.render(C,b,_,M),R.needsSwap!==!1&&(_=b,b=b===a?c:a))}if(p!==C.outputColorSpace||y!==C.toneMapping){p=C.outputColorSpace,y=C.toneMapping,d.defines={},ye.getTransfer(p)===Pe&&(d.defines.SRGB_TRANSFER="");let N=Kb[y];N&&(d.defines[N]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=_.texture,C.setRenderTarget(v),C.render(u,f),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),h.dispose(),d.dispose()}}var m0=new ei,g0=new bs(1,1),_0=new xa(1),x0=new ha,v0=new ic,y0=new _a,$g=[],Zg=[],Jg=new Float32Array(16),Kg=new Float32Array(9),jg=new Float32Array(4);function Co(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=$g[s];if(r===void 0&&(r=new Float32Array(s),$g[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function vn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function yn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function _h(i,t){let e=Zg[t];e===void 0&&(e=new Int32Array(t),Zg[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function Qb(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function tw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vn(e,t))return;i.uniform2fv(this.addr,t),yn(e,t)}}function ew(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(vn(e,t))return;i.uniform3fv(this.addr,t),yn(e,t)}}function nw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vn(e,t))return;i.uniform4fv(this.addr,t),yn(e,t)}}function iw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(vn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),yn(e,t)}else{if(vn(e,n))return;jg.set(n),i.uniformMatrix2fv(this.addr,!1,jg),yn(e,n)}}function sw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(vn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),yn(e,t)}else{if(vn(e,n))return;Kg.set(n),i.uniformMatrix3fv(this.addr,!1,Kg),yn(e,n)}}function rw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(vn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),yn(e,t)}else{if(vn(e,n))return;Jg.set(n),i.uniformMatrix4fv(this.addr,!1,Jg),yn(e,n)}}function ow(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function aw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vn(e,t))return;i.uniform2iv(this.addr,t),yn(e,t)}}function lw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(vn(e,t))return;i.uniform3iv(this.addr,t),yn(e,t)}}function cw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vn(e,t))return;i.uniform4iv(this.addr,t),yn(e,t)}}function hw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function uw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vn(e,t))return;i.uniform2uiv(this.addr,t),yn(e,t)}}function dw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(vn(e,t))return;i.uniform3uiv(this.addr,t),yn(e,t)}}function fw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vn(e,t))return;i.uniform4uiv(this.addr,t),yn(e,t)}}function xh(i){return i.version===0&&(i.compareFunction=wd,i.needsUpdate=!0),i}function pw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=xh(g0):r=m0,e.setTexture2D(t||r,s)}function mw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||v0,s)}function gw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=xh(_0):r=y0,e.setTextureCube(t||r,s)}function _w(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||x0,s)}function xw(i){switch(i){case 5126:return Qb;case 35664:return tw;case 35665:return ew;case 35666:return nw;case 35674:return iw;case 35675:return sw;case 35676:return rw;case 5124:case 35670:return ow;case 35667:case 35671:return aw;case 35668:case 35672:return lw;case 35669:case 35673:return cw;case 5125:return hw;case 36294:return uw;case 36295:return dw;case 36296:return fw;case 35678:case 36198:case 36298:case 36306:case 35682:return pw;case 35679:case 36299:case 36307:return mw;case 35680:case 36300:case 36308:case 36293:return gw;case 36289:case 36303:case 36311:case 36292:return _w}}function vw(i,t){i.uniform1fv(this.addr,t)}function yw(i,t){let e=Co(t,this.size,2);i.uniform2fv(this.addr,e)}function Sw(i,t){let e=Co(t,this.size,3);i.uniform3fv(this.addr,e)}function Mw(i,t){let e=Co(t,this.size,4);i.uniform4fv(this.addr,e)}function bw(i,t){let e=Co(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function ww(i,t){let e=Co(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function Tw(i,t){let e=Co(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function Ew(i,t){i.uniform1iv(this.addr,t)}function Aw(i,t){i.uniform2iv(this.addr,t)}function Rw(i,t){i.uniform3iv(this.addr,t)}function Cw(i,t){i.uniform4iv(this.addr,t)}function Pw(i,t){i.uniform1uiv(this.addr,t)}function Iw(i,t){i.uniform2uiv(this.addr,t)}function Lw(i,t){i.uniform3uiv(this.addr,t)}function Dw(i,t){i.uniform4uiv(this.addr,t)}function Nw(i,t,e){let n=this.cache,s=t.length,r=_h(e,s);vn(n,r)||(i.uniform1iv(this.addr,r),yn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=xh(g0):o=m0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function Uw(i,t,e){let n=this.cache,s=t.length,r=_h(e,s);vn(n,r)||(i.uniform1iv(this.addr,r),yn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||v0,r[o])}function Fw(i,t,e){let n=this.cache,s=t.length,r=_h(e,s);vn(n,r)||(i.uniform1iv(this.addr,r),yn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=xh(_0):o=y0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function Ow(i,t,e){let n=this.cache,s=t.length,r=_h(e,s);vn(n,r)||(i.uniform1iv(this.addr,r),yn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||x0,r[o])}function Bw(i){switch(i){case 5126:return vw;case 35664:return yw;case 35665:return Sw;case 35666:return Mw;case 35674:return bw;case 35675:return ww;case 35676:return Tw;case 5124:case 35670:return Ew;case 35667:case 35671:return Aw;case 35668:case 35672:return Rw;case 35669:case 35673:return Cw;case 5125:return Pw;case 36294:return Iw;case 36295:return Lw;case 36296:return Dw;case 35678:case 36198:case 36298:case 36306:case 35682:return Nw;case 35679:case 36299:case 36307:return Uw;case 35680:case 36300:case 36308:case 36293:return Fw;case 36289:case 36303:case 36311:case 36292:return Ow}}var Fd=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=xw(e.type)}},Od=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Bw(e.type)}},Bd=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},Nd=/(\w+)(\])?(\[|\.)?/g;function Qg(i,t){i.seq.push(t),i.map[t.id]=t}function kw(i,t,e){let n=i.name,s=n.length;for(Nd.lastIndex=0;;){let r=Nd.exec(n),o=Nd.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){Qg(e,l===void 0?new Fd(a,i,t):new Od(a,i,t));break}else{let d=e.map[a];d===void 0&&(d=new Bd(a),Qg(e,d)),e=d}}}var Ro=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),c=t.getUniformLocation(e,a.name);kw(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],c=n[a.id];c.needsUpdate!==!1&&a.setValue(t,c.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function t0(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var zw=37297,Vw=0;function Gw(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var e0=new re;function Hw(i){ye._getMatrix(e0,ye.workingColorSpace,i);let t=`mat3( ${e0.elements.map(e=>e.toFixed(4))} )`;switch(ye.getTransfer(i)){case la:return[t,"LinearTransferOETF"];case Pe:return[t,"sRGBTransferOETF"];default:return Zt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function n0(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+Gw(i.getShaderSource(t),a)}else return r}function Ww(i,t){let e=Hw(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Xw={[ld]:"Linear",[cd]:"Reinhard",[hd]:"Cineon",[ud]:"ACESFilmic",[fd]:"AgX",[pd]:"Neutral",[dd]:"Custom"};function qw(i,t){let e=Xw[t];return e===void 0?(Zt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var ph=new q;function Yw(){ye.getLuminanceCoefficients(ph);let i=ph.x.toFixed(4),t=ph.y.toFixed(4),e=ph.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function $w(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ba).join(`
`)}function Zw(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function Jw(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Ba(i){return i!==""}function i0(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function s0(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Kw=/^[ \t]*#include +<([\w\d./]+)>/gm;function kd(i){return i.replace(Kw,jw)}function jw(i,t){let e=de[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return kd(e)}var Qw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function r0(i){return i.replace(Qw,t1)}function t1(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function o0(i){let t=`precision ${i.precision} float;
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
#define LOW_PRECISION`),t}var e1={[Ca]:"SHADOWMAP_TYPE_PCF",[bo]:"SHADOWMAP_TYPE_VSM"};function n1(i){return e1[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var i1={[To]:"ENVMAP_MODE_REFRACTION"};function s1(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":i1[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var r1={[bc]:"ENVMAP_BLENDING_MULTIPLY",[Mg]:"ENVMAP_BLENDING_MIX",[bg]:"ENVMAP_BLENDING_ADD"};function o1(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":r1[i.combine]||"ENVMAP_BLENDING_NONE"}function a1(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,c=n1(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=s1(e),d=o1(e),u=$w(e),f=Zw(r),p=s.createProgram(),y,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Ba).join(`
`),y.length>0&&(y+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Ba).join(`
`),m.length>0&&(m+=`
`)):(y=[o0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ba).join(`
`),m=[o0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+h:"",e.envMap?"#define "+d:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ji?"#define TONE_MAPPING":"",e.toneMapping!==ji?de.tonemapping_pars_fragment:"",e.toneMapping!==ji?qw("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",de.colorspace_pars_fragment,Ww("linearToOutputTexel",e.outputColorSpace),Yw(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Ba).join(`
`)),o=kd(o),o=i0(o,e),o=s0(o,e),a=kd(a),a=i0(a,e),a=s0(a,e),o=r0(o),a=r0(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,y=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,m=["#define varying in",e.glslVersion===Td?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Td?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=g+y+o,A=g+m+a,S=t0(s,s.VERTEX_SHADER,v),C=t0(s,s.FRAGMENT_SHADER,A);s.attachShader(p,S),s.attachShader(p,C),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function M(R){if(i.debug.checkShaderErrors){let P=s.getProgramInfoLog(p)||"",O=s.getShaderInfoLog(S)||"",z=s.getShaderInfoLog(C)||"",D=P.trim(),H=O.trim(),W=z.trim(),V=!0,ht=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(V=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,S,C);else{let J=n0(s,S,"vertex"),k=n0(s,C,"fragment");se("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+D+`
`+J+`
`+k)}else D!==""?Zt("WebGLProgram: Program Info Log:",D):(H===""||W==="")&&(ht=!1);ht&&(R.diagnostics={runnable:V,programLog:D,vertexShader:{log:H,prefix:y},fragmentShader:{log:W,prefix:m}})}s.deleteShader(S),s.deleteShader(C),_=new Ro(s,p),b=Jw(s,p)}let _;this.getUniforms=function(){return _===void 0&&M(this),_};let b;this.getAttributes=function(){return b===void 0&&M(this),b};let N=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=s.getProgramParameter(p,zw)),N},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Vw++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=S,this.fragmentShader=C,this}var l1=0,zd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Vd(t),e.set(t,n)),n}},Vd=class{constructor(t){this.id=l1++,this.code=t,this.usedTimes=0}};function c1(i){return i===Qs||i===Ua||i===Fa}function h1(i,t,e,n,s,r){let o=new ua,a=new zd,c=new Set,l=[],h=new Map,d=n.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return c.add(_),_===0?"uv":`uv${_}`}function p(_,b,N,R,P,O){let z=R.fog,D=P.geometry,H=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?R.environment:null,W=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,V=t.get(_.envMap||H,W),ht=u[_.type],J=n.precision;_.precision!==null&&(J=n.getMaxPrecision(_.precision),J!==_.precision&&Zt("WebGLProgram.getParameters:",_.precision,"not supported, using",J,"instead."));let k=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,Q=k!==void 0?k.length:0,lt=0;D.morphAttributes.position!==void 0&&(lt=1),D.morphAttributes.normal!==void 0&&(lt=2),D.morphAttributes.color!==void 0&&(lt=3);let ot,K,ut,ft;if(ht){let Rt=ts[ht];ot=Rt.vertexShader,K=Rt.fragmentShader}else{ot=_.vertexShader,K=_.fragmentShader;let Rt=a.getVertexShaderStage(_),he=a.getFragmentShaderStage(_);a.update(_,Rt,he),ut=Rt.id,ft=he.id}let _t=i.getRenderTarget(),mt=i.state.buffers.depth.getReversed(),Bt=P.isInstancedMesh===!0,Kt=P.isBatchedMesh===!0,Ft=!!_.map,ce=!!_.matcap,le=!!V,ne=le&&V.isPMREMTexture===!0,Ne=!!_.aoMap,Ue=!!_.lightMap,rn=!!_.bumpMap&&_.wireframe===!1,Fe=!!_.normalMap,Mn=!!_.displacementMap,Se=!!_.emissiveMap,fn=!!_.metalnessMap,Je=!!_.roughnessMap,on=_.anisotropy>0,B=_.clearcoat>0,Ct=_.diffuseRoughness>0,Jt=_.dispersion>0,ae=_.retroreflectivity>0,wt=_.iridescence>0,Be=_.sheen>0,Gt=_.transmission>0,Yt=on&&!!_.anisotropyMap,I=B&&!!_.clearcoatMap,w=B&&!!_.clearcoatNormalMap,$=B&&!!_.clearcoatRoughnessMap,pt=Ct&&!!_.diffuseRoughnessMap,at=wt&&!!_.iridescenceMap,yt=wt&&!!_.iridescenceThicknessMap,St=Be&&!!_.sheenColorMap,nt=Be&&!!_.sheenRoughnessMap,st=!!_.specularMap,xt=!!_.specularColorMap,F=!!_.specularIntensityMap,rt=Gt&&!!_.transmissionMap,it=Gt&&!!_.thicknessMap,Tt=!!_.gradientMap,vt=!!_.alphaMap,bt=_.alphaTest>0,Ht=!!_.alphaHash,Qt=!!_.extensions,dt=ji;_.toneMapped&&(_t===null||_t.isXRRenderTarget===!0)&&(dt=i.toneMapping);let kt=ne?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,te={shaderID:ht,shaderType:_.type,shaderName:_.name,vertexShader:ot,fragmentShader:K,defines:_.defines,customVertexShaderID:ut,customFragmentShaderID:ft,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:J,batching:Kt,batchingColor:Kt&&P._colorsTexture!==null,instancing:Bt,instancingColor:Bt&&P.instanceColor!==null,instancingMorph:Bt&&P.morphTexture!==null,outputColorSpace:_t===null?i.outputColorSpace:_t.isXRRenderTarget===!0?_t.texture.colorSpace:ye.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Ft,matcap:ce,envMap:le,envMapMode:le&&V.mapping,envMapPMREM:ne,envMapMaxLod:ne?kt.length-1:null,envMapSize:ne?kt[0].width:null,aoMap:Ne,lightMap:Ue,bumpMap:rn,normalMap:Fe,displacementMap:Mn,emissiveMap:Se,normalMapObjectSpace:Fe&&_.normalMapType===Eg,normalMapTangentSpace:Fe&&_.normalMapType===hh,packedNormalMap:Fe&&_.normalMapType===hh&&c1(_.normalMap.format),metalnessMap:fn,roughnessMap:Je,anisotropy:on,anisotropyMap:Yt,clearcoat:B,clearcoatMap:I,clearcoatNormalMap:w,clearcoatRoughnessMap:$,diffuseRoughness:Ct,diffuseRoughnessMap:pt,dispersion:Jt,retroreflection:ae,iridescence:wt,iridescenceMap:at,iridescenceThicknessMap:yt,sheen:Be,sheenColorMap:St,sheenRoughnessMap:nt,specularMap:st,specularColorMap:xt,specularIntensityMap:F,transmission:Gt,transmissionMap:rt,thicknessMap:it,gradientMap:Tt,opaque:_.transparent===!1&&_.blending===wo&&_.alphaToCoverage===!1,alphaMap:vt,alphaTest:bt,alphaHash:Ht,combine:_.combine,mapUv:Ft&&f(_.map.channel),aoMapUv:Ne&&f(_.aoMap.channel),lightMapUv:Ue&&f(_.lightMap.channel),bumpMapUv:rn&&f(_.bumpMap.channel),normalMapUv:Fe&&f(_.normalMap.channel),displacementMapUv:Mn&&f(_.displacementMap.channel),emissiveMapUv:Se&&f(_.emissiveMap.channel),metalnessMapUv:fn&&f(_.metalnessMap.channel),roughnessMapUv:Je&&f(_.roughnessMap.channel),anisotropyMapUv:Yt&&f(_.anisotropyMap.channel),clearcoatMapUv:I&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:w&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:pt&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:at&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:yt&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:St&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:nt&&f(_.sheenRoughnessMap.channel),specularMapUv:st&&f(_.specularMap.channel),specularColorMapUv:xt&&f(_.specularColorMap.channel),specularIntensityMapUv:F&&f(_.specularIntensityMap.channel),transmissionMapUv:rt&&f(_.transmissionMap.channel),thicknessMapUv:it&&f(_.thicknessMap.channel),alphaMapUv:vt&&f(_.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Fe||on),vertexNormals:!!D.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:P.isPoints===!0&&!!D.attributes.uv&&(Ft||vt),fog:!!z,useFog:_.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||D.attributes.normal===void 0&&Fe===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:mt,skinning:P.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:Q,morphTextureStride:lt,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:O.filter(Rt=>Rt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&N.length>0,shadowMapType:i.shadowMap.type,toneMapping:dt,decodeVideoTexture:Ft&&_.map.isVideoTexture===!0&&ye.getTransfer(_.map.colorSpace)===Pe,decodeVideoTextureEmissive:Se&&_.emissiveMap.isVideoTexture===!0&&ye.getTransfer(_.emissiveMap.colorSpace)===Pe,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===ni,flipSided:_.side===ti,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:Qt&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qt&&_.extensions.multiDraw===!0||Kt)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return te.vertexUv1s=c.has(1),te.vertexUv2s=c.has(2),te.vertexUv3s=c.has(3),c.clear(),te}function y(_){let b=[];if(_.shaderID?b.push(_.shaderID):(b.push(_.customVertexShaderID),b.push(_.customFragmentShaderID)),_.defines!==void 0)for(let N in _.defines)b.push(N),b.push(_.defines[N]);return _.isRawShaderMaterial===!1&&(m(b,_),g(b,_),b.push(i.outputColorSpace)),b.push(_.customProgramCacheKey),b.join()}function m(_,b){_.push(b.precision),_.push(b.outputColorSpace),_.push(b.envMapMode),_.push(b.envMapPMREM),_.push(b.envMapMaxLod),_.push(b.envMapSize),_.push(b.mapUv),_.push(b.alphaMapUv),_.push(b.lightMapUv),_.push(b.aoMapUv),_.push(b.bumpMapUv),_.push(b.normalMapUv),_.push(b.displacementMapUv),_.push(b.emissiveMapUv),_.push(b.metalnessMapUv),_.push(b.roughnessMapUv),_.push(b.anisotropyMapUv),_.push(b.clearcoatMapUv),_.push(b.clearcoatNormalMapUv),_.push(b.clearcoatRoughnessMapUv),_.push(b.diffuseRoughnessMapUv),_.push(b.iridescenceMapUv),_.push(b.iridescenceThicknessMapUv),_.push(b.sheenColorMapUv),_.push(b.sheenRoughnessMapUv),_.push(b.specularMapUv),_.push(b.specularColorMapUv),_.push(b.specularIntensityMapUv),_.push(b.transmissionMapUv),_.push(b.thicknessMapUv),_.push(b.combine),_.push(b.fogExp2),_.push(b.sizeAttenuation),_.push(b.morphTargetsCount),_.push(b.numSunLights),_.push(b.numDirLights),_.push(b.numPointLights),_.push(b.numSpotLights),_.push(b.numSpotLightMaps),_.push(b.numHemiLights),_.push(b.numRectAreaLights),_.push(b.numSunLightShadows),_.push(b.numDirLightShadows),_.push(b.numPointLightShadows),_.push(b.numSpotLightShadows),_.push(b.numSpotLightShadowsWithMaps),_.push(b.numLightProbes),_.push(b.numLightProbeGrids),_.push(b.shadowMapType),_.push(b.toneMapping),_.push(b.numClippingPlanes),_.push(b.numClipIntersection),_.push(b.depthPacking)}function g(_,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function v(_){let b=u[_.type],N;if(b){let R=ts[b];N=Vg.clone(R.uniforms)}else N=_.uniforms;return N}function A(_,b){let N=h.get(b);return N!==void 0?++N.usedTimes:(N=new a1(i,b,_,s),l.push(N),h.set(b,N)),N}function S(_){if(--_.usedTimes===0){let b=l.indexOf(_);l[b]=l[l.length-1],l.pop(),h.delete(_.cacheKey),_.destroy()}}function C(_){a.remove(_)}function M(){a.dispose()}return{getParameters:p,getProgramCacheKey:y,getUniforms:v,acquireProgram:A,releaseProgram:S,releaseShaderCache:C,programs:l,dispose:M}}function u1(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,c){i.get(o)[a]=c}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function d1(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function a0(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function l0(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(u){let f=0;return u.isInstancedMesh&&(f+=2),u.isSkinnedMesh&&(f+=1),f}function a(u,f,p,y,m,g){let v=i[t];return v===void 0?(v={id:u.id,object:u,geometry:f,material:p,materialVariant:o(u),groupOrder:y,renderOrder:u.renderOrder,z:m,group:g},i[t]=v):(v.id=u.id,v.object=u,v.geometry=f,v.material=p,v.materialVariant=o(u),v.groupOrder=y,v.renderOrder=u.renderOrder,v.z=m,v.group=g),t++,v}function c(u,f,p,y,m,g,v){v.reversedDepth===!0&&(m=-m);let A=a(u,f,p,y,m,g);p.transmission>0?n.push(A):p.transparent===!0?s.push(A):e.push(A)}function l(u,f,p,y,m,g){let v=a(u,f,p,y,m,g);p.transmission>0?n.unshift(v):p.transparent===!0?s.unshift(v):e.unshift(v)}function h(u,f){e.length>1&&e.sort(u||d1),n.length>1&&n.sort(f||a0),s.length>1&&s.sort(f||a0)}function d(){for(let u=t,f=i.length;u<f;u++){let p=i[u];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:c,unshift:l,finish:d,sort:h}}function f1(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new l0,i.set(n,[o])):s>=r.length?(o=new l0,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function p1(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new q,color:new fe};break;case"SpotLight":e={position:new q,direction:new q,color:new fe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new q,color:new fe,distance:0,decay:0};break;case"HemisphereLight":e={direction:new q,skyColor:new fe,groundColor:new fe};break;case"RectAreaLight":e={color:new fe,position:new q,halfWidth:new q,halfHeight:new q};break}return i[t.id]=e,e}}}function m1(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ee};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ee};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ee,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var g1=0;function _1(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function x1(i){let t=new p1,e=m1(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new q);let s=new q,r=new Ae,o=new Ae;function a(l){let h=0,d=0,u=0;for(let O=0;O<9;O++)n.probe[O].set(0,0,0);let f=0,p=0,y=0,m=0,g=0,v=0,A=0,S=0,C=0,M=0,_=0,b=0,N=0,R=0;l.sort(_1);for(let O=0,z=l.length;O<z;O++){let D=l[O],H=D.color,W=D.intensity,V=D.distance,ht=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===Qs?ht=D.shadow.map.texture:ht=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)h+=H.r*W,d+=H.g*W,u+=H.b*W;else if(D.isLightProbe){for(let J=0;J<9;J++)n.probe[J].addScaledVector(D.sh.coefficients[J],W);R++}else if(D.isSunLight){let J=t.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let k=D.shadow,Q=e.get(D);Q.shadowIntensity=k.intensity,Q.shadowBias=k.bias,Q.shadowNormalBias=k.normalBias,Q.shadowRadius=k.radius,Q.shadowMapSize.copy(k.mapSize).multiply(k.getFrameExtents()),n.sunShadow[p]=Q,n.sunShadowMap[p]=ht;let lt=k.getViewportCount();for(let ot=0;ot<lt;ot++)n.sunShadowMatrix[y+ot]=k.getMatrix(ot),n.sunShadowCascade[y+ot]=k._cascadeData[ot];y+=lt,p++}n.sun[f]=J,f++}else if(D.isDirectionalLight){let J=t.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let k=D.shadow,Q=e.get(D);Q.shadowIntensity=k.intensity,Q.shadowBias=k.bias,Q.shadowNormalBias=k.normalBias,Q.shadowRadius=k.radius,Q.shadowMapSize=k.mapSize,n.directionalShadow[m]=Q,n.directionalShadowMap[m]=ht,n.directionalShadowMatrix[m]=D.shadow.matrix,C++}n.directional[m]=J,m++}else if(D.isSpotLight){let J=t.get(D);J.position.setFromMatrixPosition(D.matrixWorld),J.color.copy(H).multiplyScalar(W),J.distance=V,J.coneCos=Math.cos(D.angle),J.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),J.decay=D.decay,n.spot[v]=J;let k=D.shadow;if(D.map&&(n.spotLightMap[b]=D.map,b++,k.updateMatrices(D),D.castShadow&&N++),n.spotLightMatrix[v]=k.matrix,D.castShadow){let Q=e.get(D);Q.shadowIntensity=k.intensity,Q.shadowBias=k.bias,Q.shadowNormalBias=k.normalBias,Q.shadowRadius=k.radius,Q.shadowMapSize=k.mapSize,n.spotShadow[v]=Q,n.spotShadowMap[v]=ht,_++}v++}else if(D.isRectAreaLight){let J=t.get(D);J.color.copy(H).multiplyScalar(W),J.halfWidth.set(D.width*.5,0,0),J.halfHeight.set(0,D.height*.5,0),n.rectArea[A]=J,A++}else if(D.isPointLight){let J=t.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),J.distance=D.distance,J.decay=D.decay,D.castShadow){let k=D.shadow,Q=e.get(D);Q.shadowIntensity=k.intensity,Q.shadowBias=k.bias,Q.shadowNormalBias=k.normalBias,Q.shadowRadius=k.radius,Q.shadowMapSize=k.mapSize,Q.shadowCameraNear=k.camera.near,Q.shadowCameraFar=k.camera.far,n.pointShadow[g]=Q,n.pointShadowMap[g]=ht,n.pointShadowMatrix[g]=D.shadow.matrix,M++}n.point[g]=J,g++}else if(D.isHemisphereLight){let J=t.get(D);J.skyColor.copy(D.color).multiplyScalar(W),J.groundColor.copy(D.groundColor).multiplyScalar(W),n.hemi[S]=J,S++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Lt.LTC_FLOAT_1,n.rectAreaLTC2=Lt.LTC_FLOAT_2):(n.rectAreaLTC1=Lt.LTC_HALF_1,n.rectAreaLTC2=Lt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=d,n.ambient[2]=u;let P=n.hash;(P.sunLength!==f||P.directionalLength!==m||P.pointLength!==g||P.spotLength!==v||P.rectAreaLength!==A||P.hemiLength!==S||P.numSunShadows!==p||P.numDirectionalShadows!==C||P.numPointShadows!==M||P.numSpotShadows!==_||P.numSpotMaps!==b||P.numLightProbes!==R)&&(n.sun.length=f,n.directional.length=m,n.spot.length=v,n.rectArea.length=A,n.point.length=g,n.hemi.length=S,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=M,n.pointShadowMap.length=M,n.pointShadowMatrix.length=M,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+b-N,n.spotLightMap.length=b,n.numSpotLightShadowsWithMaps=N,n.numLightProbes=R,P.sunLength=f,P.directionalLength=m,P.pointLength=g,P.spotLength=v,P.rectAreaLength=A,P.hemiLength=S,P.numSunShadows=p,P.numDirectionalShadows=C,P.numPointShadows=M,P.numSpotShadows=_,P.numSpotMaps=b,P.numLightProbes=R,n.version=g1++)}function c(l,h){let d=0,u=0,f=0,p=0,y=0,m=0,g=h.matrixWorldInverse;for(let v=0,A=l.length;v<A;v++){let S=l[v];if(S.isSunLight){let C=n.sun[d];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(g),d++}else if(S.isDirectionalLight){let C=n.directional[u];C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),u++}else if(S.isSpotLight){let C=n.spot[p];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(g),C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),p++}else if(S.isRectAreaLight){let C=n.rectArea[y];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(g),o.identity(),r.copy(S.matrixWorld),r.premultiply(g),o.extractRotation(r),C.halfWidth.set(S.width*.5,0,0),C.halfHeight.set(0,S.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),y++}else if(S.isPointLight){let C=n.point[f];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(g),f++}else if(S.isHemisphereLight){let C=n.hemi[m];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(g),m++}}}return{setup:a,setupView:c,state:n}}function c0(i){let t=new x1(i),e=[],n=[],s=[];function r(d){h.camera=d,e.length=0,n.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):e.push(d)}function a(d){n.push(d)}function c(){t.setup(e),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function l(d){t.setupView(e,d)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function v1(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new c0(i),t.set(s,[a])):r>=o.length?(a=new c0(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var y1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,S1=`uniform sampler2D shadow_pass;
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
}`,M1=[new q(1,0,0),new q(-1,0,0),new q(0,1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1)],b1=[new q(0,-1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1),new q(0,-1,0),new q(0,-1,0)],h0=new Ae,Oa=new q,Ud=new q;function w1(i,t,e){let n=new Xs,s=new ee,r=new ee,o=new $e,a=new cc,c=new hc,l={},h=e.maxTextureSize,d={[js]:ti,[ti]:js,[ni]:ni},u=new Ki({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ee},radius:{value:4}},vertexShader:y1,fragmentShader:S1}),f=u.clone();f.defines.HORIZONTAL_PASS=1;let p=new Dn;p.setAttribute("position",new Vn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Hn(p,u),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ca;let g=this.type;this.render=function(M,_,b){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||M.length===0)return;this.type===ig&&(Zt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ca);let N=i.getRenderTarget(),R=i.getActiveCubeFace(),P=i.getActiveMipmapLevel(),O=i.state;O.setBlending(vr),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let z=g!==this.type;z&&_.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(H=>H.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,H=M.length;D<H;D++){let W=M[D],V=W.shadow;if(V===void 0){Zt("WebGLShadowMap:",W,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let ht=V.getFrameExtents();s.multiply(ht),r.copy(V.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ht.x),s.x=r.x*ht.x,V.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ht.y),s.y=r.y*ht.y,V.mapSize.y=r.y));let J=i.state.buffers.depth.getReversed();if(V.camera._reversedDepth=J,V.map===null||z===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===bo){if(W.isPointLight){Zt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new mi(s.x,s.y,{format:Qs,type:Oi,minFilter:Ln,magFilter:Ln,generateMipmaps:!1}),V.map.texture.name=W.name+".shadowMap",V.map.depthTexture=new bs(s.x,s.y,wi),V.map.depthTexture.name=W.name+".shadowMapDepth",V.map.depthTexture.format=vs,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Pn,V.map.depthTexture.magFilter=Pn}else W.isPointLight?(V.map=new ka(s.x),V.map.depthTexture=new xa(s.x,Fi)):(V.map=new mi(s.x,s.y),V.map.depthTexture=new bs(s.x,s.y,Fi)),V.map.depthTexture.name=W.name+".shadowMap",V.map.depthTexture.format=vs,this.type===Ca?(V.map.depthTexture.compareFunction=J?bd:Md,V.map.depthTexture.minFilter=Ln,V.map.depthTexture.magFilter=Ln):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Pn,V.map.depthTexture.magFilter=Pn);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let k=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();W.isPointLight!==!0&&V.updateMatrices(W,b);let Q=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:b.layers;for(let lt=0;lt<k;lt++){let ot=V.getCamera(lt);if(W.isPointLight){let K=V.camera,ut=V.matrix,ft=W.distance||K.far;ft!==K.far&&(K.far=ft,K.updateProjectionMatrix()),Oa.setFromMatrixPosition(W.matrixWorld),K.position.copy(Oa),Ud.copy(K.position),Ud.add(M1[lt]),K.up.copy(b1[lt]),K.lookAt(Ud),K.updateMatrixWorld(),ut.makeTranslation(-Oa.x,-Oa.y,-Oa.z),h0.multiplyMatrices(K.projectionMatrix,K.matrixWorldInverse),V._frustum.setFromProjectionMatrix(h0,K.coordinateSystem,K.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)i.setRenderTarget(V.map,lt),i.clear();else{lt===0&&(i.setRenderTarget(V.map),i.clear());let K=V.getViewport(lt);o.set(r.x*K.x,r.y*K.y,r.x*K.z,r.y*K.w),O.viewport(o)}n=V.getFrustum(lt),S(_,b,ot,W,Q,this.type)}V.isPointLightShadow!==!0&&this.type===bo&&v(V,b),V.needsUpdate=!1}g=this.type,m.needsUpdate=!1,i.setRenderTarget(N,R,P)};function v(M,_){let b=t.update(y);u.defines.VSM_SAMPLES!==M.blurSamples&&(u.defines.VSM_SAMPLES=M.blurSamples,f.defines.VSM_SAMPLES=M.blurSamples,u.needsUpdate=!0,f.needsUpdate=!0),M.mapPass===null?M.mapPass=new mi(s.x,s.y,{format:Qs,type:Oi}):(M.mapPass.width!==M.map.width||M.mapPass.height!==M.map.height)&&M.mapPass.setSize(M.map.width,M.map.height),u.uniforms.shadow_pass.value=M.map.depthTexture,u.uniforms.resolution.value.set(M.map.width,M.map.height),u.uniforms.radius.value=M.radius,i.setRenderTarget(M.mapPass),i.clear(),i.renderBufferDirect(_,null,b,u,y,null),f.uniforms.shadow_pass.value=M.mapPass.texture,f.uniforms.resolution.value.set(M.map.width,M.map.height),f.uniforms.radius.value=M.radius,i.setRenderTarget(M.map),i.clear(),i.renderBufferDirect(_,null,b,f,y,null)}function A(M,_,b,N){let R=null,P=b.isPointLight===!0?M.customDistanceMaterial:M.customDepthMaterial;if(P!==void 0)R=P;else if(R=b.isPointLight===!0?c:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let O=R.uuid,z=_.uuid,D=l[O];D===void 0&&(D={},l[O]=D);let H=D[z];H===void 0&&(H=R.clone(),D[z]=H,_.addEventListener("dispose",C)),R=H}if(R.visible=_.visible,R.wireframe=_.wireframe,N===bo?R.side=_.shadowSide!==null?_.shadowSide:_.side:R.side=_.shadowSide!==null?_.shadowSide:d[_.side],R.alphaMap=_.alphaMap,R.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,R.map=_.map,R.clipShadows=_.clipShadows,R.clippingPlanes=_.clippingPlanes,R.clipIntersection=_.clipIntersection,R.displacementMap=_.displacementMap,R.displacementScale=_.displacementScale,R.displacementBias=_.displacementBias,R.wireframeLinewidth=_.wireframeLinewidth,R.linewidth=_.linewidth,b.isPointLight===!0&&R.isMeshDistanceMaterial===!0){let O=i.properties.get(R);O.light=b}return R}function S(M,_,b,N,R,P){if(M.visible===!1)return;if(M.layers.test(R)&&(M.isMesh||M.isLine||M.isPoints)&&(M.castShadow||M.receiveShadow&&P===bo)&&(!M.frustumCulled||M.intersectsFrustum(n))){M.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,M.matrixWorld);let D=t.update(M),H=M.material;if(Array.isArray(H)){let W=D.groups;for(let V=0,ht=W.length;V<ht;V++){let J=W[V],k=H[J.materialIndex];if(k&&k.visible){let Q=A(M,k,N,P);M.onBeforeShadow(i,M,_,b,D,Q,J),i.renderBufferDirect(b,null,D,Q,M,J),M.onAfterShadow(i,M,_,b,D,Q,J)}}}else if(H.visible){let W=A(M,H,N,P);M.onBeforeShadow(i,M,_,b,D,W,null),i.renderBufferDirect(b,null,D,W,M,null),M.onAfterShadow(i,M,_,b,D,W,null)}}let z=M.children;for(let D=0,H=z.length;D<H;D++)S(z[D],_,b,N,R,P)}function C(M){M.target.removeEventListener("dispose",C);for(let b in l){let N=l[b],R=M.target.uuid;R in N&&(N[R].dispose(),delete N[R])}}}function T1(i,t){function e(){let F=!1,rt=new $e,it=null,Tt=new $e(0,0,0,0);return{setMask:function(vt){it!==vt&&!F&&(i.colorMask(vt,vt,vt,vt),it=vt)},setLocked:function(vt){F=vt},setClear:function(vt,bt,Ht,Qt,dt){dt===!0&&(vt*=Qt,bt*=Qt,Ht*=Qt),rt.set(vt,bt,Ht,Qt),Tt.equals(rt)===!1&&(i.clearColor(vt,bt,Ht,Qt),Tt.copy(rt))},reset:function(){F=!1,it=null,Tt.set(-1,0,0,0)}}}function n(){let F=!1,rt=!1,it=null,Tt=null,vt=null;return{setReversed:function(bt){if(rt!==bt){let Ht=t.get("EXT_clip_control");bt?Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.ZERO_TO_ONE_EXT):Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.NEGATIVE_ONE_TO_ONE_EXT),rt=bt;let Qt=vt;vt=null,this.setClear(Qt)}},getReversed:function(){return rt},setTest:function(bt){bt?mt(i.DEPTH_TEST):Bt(i.DEPTH_TEST)},setMask:function(bt){it!==bt&&!F&&(i.depthMask(bt),it=bt)},setFunc:function(bt){if(rt&&(bt=Og[bt]),Tt!==bt){switch(bt){case Xl:i.depthFunc(i.NEVER);break;case ql:i.depthFunc(i.ALWAYS);break;case Yl:i.depthFunc(i.LESS);break;case ho:i.depthFunc(i.LEQUAL);break;case $l:i.depthFunc(i.EQUAL);break;case Zl:i.depthFunc(i.GEQUAL);break;case Jl:i.depthFunc(i.GREATER);break;case Kl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Tt=bt}},setLocked:function(bt){F=bt},setClear:function(bt){vt!==bt&&(vt=bt,rt&&(bt=1-bt),i.clearDepth(bt))},reset:function(){F=!1,it=null,Tt=null,vt=null,rt=!1}}}function s(){let F=!1,rt=null,it=null,Tt=null,vt=null,bt=null,Ht=null,Qt=null,dt=null;return{setTest:function(kt){F||(kt?mt(i.STENCIL_TEST):Bt(i.STENCIL_TEST))},setMask:function(kt){rt!==kt&&!F&&(i.stencilMask(kt),rt=kt)},setFunc:function(kt,te,Rt){(it!==kt||Tt!==te||vt!==Rt)&&(i.stencilFunc(kt,te,Rt),it=kt,Tt=te,vt=Rt)},setOp:function(kt,te,Rt){(bt!==kt||Ht!==te||Qt!==Rt)&&(i.stencilOp(kt,te,Rt),bt=kt,Ht=te,Qt=Rt)},setLocked:function(kt){F=kt},setClear:function(kt){dt!==kt&&(i.clearStencil(kt),dt=kt)},reset:function(){F=!1,rt=null,it=null,Tt=null,vt=null,bt=null,Ht=null,Qt=null,dt=null}}}let r=new e,o=new n,a=new s,c={},l=new WeakMap,h={},d={},u={},f=new WeakMap,p=[],y=null,m=!1,g=null,v=null,A=null,S=null,C=null,M=null,_=null,b=new fe(0,0,0),N=0,R=!1,P=null,O=null,z=null,D=null,H=null,W=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,ht=0,J=i.getParameter(i.VERSION);J.indexOf("WebGL")!==-1?(ht=parseFloat(/^WebGL (\d)/.exec(J)[1]),V=ht>=1):J.indexOf("OpenGL ES")!==-1&&(ht=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),V=ht>=2);let k=null,Q={},lt=i.getParameter(i.SCISSOR_BOX),ot=i.getParameter(i.VIEWPORT),K=new $e().fromArray(lt),ut=new $e().fromArray(ot);function ft(F,rt,it,Tt){let vt=new Uint8Array(4),bt=i.createTexture();i.bindTexture(F,bt),i.texParameteri(F,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(F,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ht=0;Ht<it;Ht++)F===i.TEXTURE_3D||F===i.TEXTURE_2D_ARRAY?i.texImage3D(rt,0,i.RGBA,1,1,Tt,0,i.RGBA,i.UNSIGNED_BYTE,vt):i.texImage2D(rt+Ht,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,vt);return bt}let _t={};_t[i.TEXTURE_2D]=ft(i.TEXTURE_2D,i.TEXTURE_2D,1),_t[i.TEXTURE_CUBE_MAP]=ft(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),_t[i.TEXTURE_2D_ARRAY]=ft(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),_t[i.TEXTURE_3D]=ft(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),mt(i.DEPTH_TEST),o.setFunc(ho),rn(!1),Fe(nd),mt(i.CULL_FACE),Ne(vr);function mt(F){h[F]!==!0&&(i.enable(F),h[F]=!0)}function Bt(F){h[F]!==!1&&(i.disable(F),h[F]=!1)}function Kt(F,rt){return u[F]!==rt?(i.bindFramebuffer(F,rt),u[F]=rt,F===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=rt),F===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=rt),!0):!1}function Ft(F,rt){let it=p,Tt=!1;if(F){it=f.get(rt),it===void 0&&(it=[],f.set(rt,it));let vt=F.textures;if(it.length!==vt.length||it[0]!==i.COLOR_ATTACHMENT0){for(let bt=0,Ht=vt.length;bt<Ht;bt++)it[bt]=i.COLOR_ATTACHMENT0+bt;it.length=vt.length,Tt=!0}}else it[0]!==i.BACK&&(it[0]=i.BACK,Tt=!0);Tt&&i.drawBuffers(it)}function ce(F){return y!==F?(i.useProgram(F),y=F,!0):!1}let le={[yr]:i.FUNC_ADD,[rg]:i.FUNC_SUBTRACT,[og]:i.FUNC_REVERSE_SUBTRACT};le[ag]=i.MIN,le[lg]=i.MAX;let ne={[cg]:i.ZERO,[hg]:i.ONE,[ug]:i.SRC_COLOR,[od]:i.SRC_ALPHA,[_g]:i.SRC_ALPHA_SATURATE,[mg]:i.DST_COLOR,[fg]:i.DST_ALPHA,[dg]:i.ONE_MINUS_SRC_COLOR,[ad]:i.ONE_MINUS_SRC_ALPHA,[gg]:i.ONE_MINUS_DST_COLOR,[pg]:i.ONE_MINUS_DST_ALPHA,[xg]:i.CONSTANT_COLOR,[vg]:i.ONE_MINUS_CONSTANT_COLOR,[yg]:i.CONSTANT_ALPHA,[Sg]:i.ONE_MINUS_CONSTANT_ALPHA};function Ne(F,rt,it,Tt,vt,bt,Ht,Qt,dt,kt){if(F===vr){m===!0&&(Bt(i.BLEND),m=!1);return}if(m===!1&&(mt(i.BLEND),m=!0),F!==sg){if(F!==g||kt!==R){if((v!==yr||C!==yr)&&(i.blendEquation(i.FUNC_ADD),v=yr,C=yr),kt)switch(F){case wo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case id:i.blendFunc(i.ONE,i.ONE);break;case sd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case rd:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:se("WebGLState: Invalid blending: ",F);break}else switch(F){case wo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case id:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case sd:se("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case rd:se("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:se("WebGLState: Invalid blending: ",F);break}A=null,S=null,M=null,_=null,b.set(0,0,0),N=0,g=F,R=kt}return}vt=vt||rt,bt=bt||it,Ht=Ht||Tt,(rt!==v||vt!==C)&&(i.blendEquationSeparate(le[rt],le[vt]),v=rt,C=vt),(it!==A||Tt!==S||bt!==M||Ht!==_)&&(i.blendFuncSeparate(ne[it],ne[Tt],ne[bt],ne[Ht]),A=it,S=Tt,M=bt,_=Ht),(Qt.equals(b)===!1||dt!==N)&&(i.blendColor(Qt.r,Qt.g,Qt.b,dt),b.copy(Qt),N=dt),g=F,R=!1}function Ue(F,rt){F.side===ni?Bt(i.CULL_FACE):mt(i.CULL_FACE);let it=F.side===ti;rt&&(it=!it),rn(it),F.blending===wo&&F.transparent===!1?Ne(vr):Ne(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let Tt=F.stencilWrite;a.setTest(Tt),Tt&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),Se(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?mt(i.SAMPLE_ALPHA_TO_COVERAGE):Bt(i.SAMPLE_ALPHA_TO_COVERAGE)}function rn(F){P!==F&&(F?i.frontFace(i.CW):i.frontFace(i.CCW),P=F)}function Fe(F){F!==eg?(mt(i.CULL_FACE),F!==O&&(F===nd?i.cullFace(i.BACK):F===ng?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Bt(i.CULL_FACE),O=F}function Mn(F){F!==z&&(V&&i.lineWidth(F),z=F)}function Se(F,rt,it){F?(mt(i.POLYGON_OFFSET_FILL),(D!==rt||H!==it)&&(D=rt,H=it,o.getReversed()&&(rt=-rt,it=-it),i.polygonOffset(rt,it))):Bt(i.POLYGON_OFFSET_FILL)}function fn(F){F?mt(i.SCISSOR_TEST):Bt(i.SCISSOR_TEST)}function Je(F){F===void 0&&(F=i.TEXTURE0+W-1),k!==F&&(i.activeTexture(F),k=F)}function on(F,rt,it){it===void 0&&(k===null?it=i.TEXTURE0+W-1:it=k);let Tt=Q[it];Tt===void 0&&(Tt={type:void 0,texture:void 0},Q[it]=Tt),(Tt.type!==F||Tt.texture!==rt)&&(k!==it&&(i.activeTexture(it),k=it),i.bindTexture(F,rt||_t[F]),Tt.type=F,Tt.texture=rt)}function B(){let F=Q[k];F!==void 0&&F.type!==void 0&&(i.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Ct(){try{i.compressedTexImage2D(...arguments)}catch(F){se("WebGLState:",F)}}function Jt(){try{i.compressedTexImage3D(...arguments)}catch(F){se("WebGLState:",F)}}function ae(){try{i.texSubImage2D(...arguments)}catch(F){se("WebGLState:",F)}}function wt(){try{i.texSubImage3D(...arguments)}catch(F){se("WebGLState:",F)}}function Be(){try{i.compressedTexSubImage2D(...arguments)}catch(F){se("WebGLState:",F)}}function Gt(){try{i.compressedTexSubImage3D(...arguments)}catch(F){se("WebGLState:",F)}}function Yt(){try{i.texStorage2D(...arguments)}catch(F){se("WebGLState:",F)}}function I(){try{i.texStorage3D(...arguments)}catch(F){se("WebGLState:",F)}}function w(){try{i.texImage2D(...arguments)}catch(F){se("WebGLState:",F)}}function $(){try{i.texImage3D(...arguments)}catch(F){se("WebGLState:",F)}}function pt(F){return d[F]!==void 0?d[F]:i.getParameter(F)}function at(F,rt){d[F]!==rt&&(i.pixelStorei(F,rt),d[F]=rt)}function yt(F){K.equals(F)===!1&&(i.scissor(F.x,F.y,F.z,F.w),K.copy(F))}function St(F){ut.equals(F)===!1&&(i.viewport(F.x,F.y,F.z,F.w),ut.copy(F))}function nt(F,rt){let it=l.get(rt);it===void 0&&(it=new WeakMap,l.set(rt,it));let Tt=it.get(F);Tt===void 0&&(Tt=i.getUniformBlockIndex(rt,F.name),i.uniformBlockBinding(rt,Tt,Tt),it.set(F,Tt))}function st(F,rt,it){let vt=l.get(rt).get(F);c[vt]!==it&&(i.bindBufferBase(i.UNIFORM_BUFFER,vt,it),c[vt]=it)}function xt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},d={},k=null,Q={},u={},c={},f=new WeakMap,p=[],y=null,m=!1,g=null,v=null,A=null,S=null,C=null,M=null,_=null,b=new fe(0,0,0),N=0,R=!1,P=null,O=null,z=null,D=null,H=null,K.set(0,0,i.canvas.width,i.canvas.height),ut.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:mt,disable:Bt,bindFramebuffer:Kt,drawBuffers:Ft,useProgram:ce,setBlending:Ne,setMaterial:Ue,setFlipSided:rn,setCullFace:Fe,setLineWidth:Mn,setPolygonOffset:Se,setScissorTest:fn,activeTexture:Je,bindTexture:on,unbindTexture:B,compressedTexImage2D:Ct,compressedTexImage3D:Jt,texImage2D:w,texImage3D:$,pixelStorei:at,getParameter:pt,updateUBOMapping:nt,uniformBlockBinding:st,texStorage2D:Yt,texStorage3D:I,texSubImage2D:ae,texSubImage3D:wt,compressedTexSubImage2D:Be,compressedTexSubImage3D:Gt,scissor:yt,viewport:St,reset:xt}}function E1(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new ee,h=new WeakMap,d=new Set,u,f=new WeakMap,p=new Set,y=new FinalizationRegistry(I=>p.delete(I)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(I,w){return m?new OffscreenCanvas(I,w):ca("canvas")}function v(I,w,$){let pt=1,at=Yt(I);if((at.width>$||at.height>$)&&(pt=$/Math.max(at.width,at.height)),pt<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let yt=Math.floor(pt*at.width),St=Math.floor(pt*at.height);u===void 0&&(u=g(yt,St));let nt=w?g(yt,St):u;return nt.width=yt,nt.height=St,nt.getContext("2d").drawImage(I,0,0,yt,St),Zt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+yt+"x"+St+")."),nt}else return"data"in I&&Zt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),I;return I}function A(I){return I.generateMipmaps}function S(I){i.generateMipmap(I)}function C(I){return I.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?i.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function M(I,w,$,pt,at,yt=!1){if(I!==null){if(i[I]!==void 0)return i[I];Zt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let St;pt&&(St=t.get("EXT_texture_norm16"),St||Zt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=w;if(w===i.RED&&($===i.FLOAT&&(nt=i.R32F),$===i.HALF_FLOAT&&(nt=i.R16F),$===i.UNSIGNED_BYTE&&(nt=i.R8),$===i.UNSIGNED_SHORT&&St&&(nt=St.R16_EXT),$===i.SHORT&&St&&(nt=St.R16_SNORM_EXT)),w===i.RED_INTEGER&&($===i.UNSIGNED_BYTE&&(nt=i.R8UI),$===i.UNSIGNED_SHORT&&(nt=i.R16UI),$===i.UNSIGNED_INT&&(nt=i.R32UI),$===i.BYTE&&(nt=i.R8I),$===i.SHORT&&(nt=i.R16I),$===i.INT&&(nt=i.R32I)),w===i.RG&&($===i.FLOAT&&(nt=i.RG32F),$===i.HALF_FLOAT&&(nt=i.RG16F),$===i.UNSIGNED_BYTE&&(nt=i.RG8),$===i.UNSIGNED_SHORT&&St&&(nt=St.RG16_EXT),$===i.SHORT&&St&&(nt=St.RG16_SNORM_EXT)),w===i.RG_INTEGER&&($===i.UNSIGNED_BYTE&&(nt=i.RG8UI),$===i.UNSIGNED_SHORT&&(nt=i.RG16UI),$===i.UNSIGNED_INT&&(nt=i.RG32UI),$===i.BYTE&&(nt=i.RG8I),$===i.SHORT&&(nt=i.RG16I),$===i.INT&&(nt=i.RG32I)),w===i.RGB_INTEGER&&($===i.UNSIGNED_BYTE&&(nt=i.RGB8UI),$===i.UNSIGNED_SHORT&&(nt=i.RGB16UI),$===i.UNSIGNED_INT&&(nt=i.RGB32UI),$===i.BYTE&&(nt=i.RGB8I),$===i.SHORT&&(nt=i.RGB16I),$===i.INT&&(nt=i.RGB32I)),w===i.RGBA_INTEGER&&($===i.UNSIGNED_BYTE&&(nt=i.RGBA8UI),$===i.UNSIGNED_SHORT&&(nt=i.RGBA16UI),$===i.UNSIGNED_INT&&(nt=i.RGBA32UI),$===i.BYTE&&(nt=i.RGBA8I),$===i.SHORT&&(nt=i.RGBA16I),$===i.INT&&(nt=i.RGBA32I)),w===i.RGB&&($===i.UNSIGNED_SHORT&&St&&(nt=St.RGB16_EXT),$===i.SHORT&&St&&(nt=St.RGB16_SNORM_EXT),$===i.UNSIGNED_INT_5_9_9_9_REV&&(nt=i.RGB9_E5),$===i.UNSIGNED_INT_10F_11F_11F_REV&&(nt=i.R11F_G11F_B10F)),w===i.RGBA){let st=yt?la:ye.getTransfer(at);$===i.FLOAT&&(nt=i.RGBA32F),$===i.HALF_FLOAT&&(nt=i.RGBA16F),$===i.UNSIGNED_BYTE&&(nt=st===Pe?i.SRGB8_ALPHA8:i.RGBA8),$===i.UNSIGNED_SHORT&&St&&(nt=St.RGBA16_EXT),$===i.SHORT&&St&&(nt=St.RGBA16_SNORM_EXT),$===i.UNSIGNED_SHORT_4_4_4_4&&(nt=i.RGBA4),$===i.UNSIGNED_SHORT_5_5_5_1&&(nt=i.RGB5_A1)}return(nt===i.R16F||nt===i.R32F||nt===i.RG16F||nt===i.RG32F||nt===i.RGBA16F||nt===i.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function _(I,w){let $;return I?w===null||w===Fi||w===Mr?$=i.DEPTH24_STENCIL8:w===wi?$=i.DEPTH32F_STENCIL8:w===Eo&&($=i.DEPTH24_STENCIL8,Zt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Fi||w===Mr?$=i.DEPTH_COMPONENT24:w===wi?$=i.DEPTH_COMPONENT32F:w===Eo&&($=i.DEPTH_COMPONENT16),$}function b(I,w){return A(I)===!0||I.isFramebufferTexture&&I.minFilter!==Pn&&I.minFilter!==Ln?Math.log2(Math.max(w.width,w.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?w.mipmaps.length:1}function N(I){let w=new WeakRef(I);n.get(I).__ref=w,p.add(w),y.register(I,w,w)}function R(I){let w=n.get(I).__ref;w!==void 0&&(p.delete(w),y.unregister(w))}function P(I){z(I.target)}function O(I){D(I.target)}function z(I){I.removeEventListener("dispose",P),R(I),W(I),I.isVideoTexture&&h.delete(I),I.isHTMLTexture&&d.delete(I)}function D(I){I.removeEventListener("dispose",O),R(I),ht(I)}function H(){for(let I of p){let w=I.deref();w!==void 0&&(w.isRenderTarget===!0?D(w):z(w))}p.clear(),d.clear()}function W(I){let w=n.get(I);if(w.__webglInit===void 0)return;let $=I.source,pt=f.get($);if(pt){let at=pt[w.__cacheKey];at.usedTimes--,at.usedTimes===0&&V(I),Object.keys(pt).length===0&&f.delete($)}n.remove(I)}function V(I){let w=n.get(I);i.deleteTexture(w.__webglTexture);let $=I.source,pt=f.get($);delete pt[w.__cacheKey],o.memory.textures--}function ht(I){let w=n.get(I);w.__depthDisposeCallback&&w.__depthDisposeCallback();let $=I.depthTexture;if($&&$.renderTarget===I&&z($),I.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(w.__webglFramebuffer[at]))for(let yt=0;yt<w.__webglFramebuffer[at].length;yt++)i.deleteFramebuffer(w.__webglFramebuffer[at][yt]);else i.deleteFramebuffer(w.__webglFramebuffer[at]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[at])}else{if(Array.isArray(w.__webglFramebuffer))for(let at=0;at<w.__webglFramebuffer.length;at++)i.deleteFramebuffer(w.__webglFramebuffer[at]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let at=0;at<w.__webglColorRenderbuffer.length;at++)w.__webglColorRenderbuffer[at]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[at]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let pt=I.textures;for(let at=0,yt=pt.length;at<yt;at++){let St=n.get(pt[at]);St.__webglTexture&&(i.deleteTexture(St.__webglTexture),o.memory.textures--),n.remove(pt[at])}n.remove(I)}let J=0;function k(){J=0}function Q(){return J}function lt(I){J=I}function ot(){let I=J;return I>=s.maxTextures&&Zt("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,I}function K(I){let w=[];return w.push(I.wrapS),w.push(I.wrapT),w.push(I.wrapR||0),w.push(I.magFilter),w.push(I.minFilter),w.push(I.anisotropy),w.push(I.internalFormat),w.push(I.format),w.push(I.type),w.push(I.generateMipmaps),w.push(I.mipmapsAutoUpdate),w.push(I.premultiplyAlpha),w.push(I.flipY),w.push(I.unpackAlignment),w.push(I.colorSpace),w.join()}function ut(I,w){let $=n.get(I);if(I.isVideoTexture&&Be(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&$.__version!==I.version){let pt=I.image;if(pt===null)Zt("WebGLRenderer: Texture marked for update but no image data found.");else if(pt.complete===!1)Zt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ue($,I,w);return}}else I.isExternalTexture&&($.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,$.__webglTexture,i.TEXTURE0+w)}function ft(I,w){let $=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&$.__version!==I.version){Ue($,I,w);return}else I.isExternalTexture&&($.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,$.__webglTexture,i.TEXTURE0+w)}function _t(I,w){let $=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&$.__version!==I.version){Ue($,I,w);return}e.bindTexture(i.TEXTURE_3D,$.__webglTexture,i.TEXTURE0+w)}function mt(I,w){let $=n.get(I);if(I.version>0&&$.__version!==I.version){rn($,I,w);return}e.bindTexture(i.TEXTURE_CUBE_MAP,$.__webglTexture,i.TEXTURE0+w)}let Bt={[jl]:i.REPEAT,[Zi]:i.CLAMP_TO_EDGE,[Ql]:i.MIRRORED_REPEAT},Kt={[Pn]:i.NEAREST,[wg]:i.NEAREST_MIPMAP_NEAREST,[Pa]:i.NEAREST_MIPMAP_LINEAR,[Ln]:i.LINEAR,[Ec]:i.LINEAR_MIPMAP_NEAREST,[ws]:i.LINEAR_MIPMAP_LINEAR},Ft={[Rg]:i.NEVER,[wd]:i.ALWAYS,[Cg]:i.LESS,[Md]:i.LEQUAL,[Pg]:i.EQUAL,[bd]:i.GEQUAL,[Ig]:i.GREATER,[Lg]:i.NOTEQUAL};function ce(I,w){if(w.type===wi&&t.has("OES_texture_float_linear")===!1&&(w.magFilter===Ln||w.magFilter===Ec||w.magFilter===Pa||w.magFilter===ws||w.minFilter===Ln||w.minFilter===Ec||w.minFilter===Pa||w.minFilter===ws)&&Zt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(I,i.TEXTURE_WRAP_S,Bt[w.wrapS]),i.texParameteri(I,i.TEXTURE_WRAP_T,Bt[w.wrapT]),(I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY)&&i.texParameteri(I,i.TEXTURE_WRAP_R,Bt[w.wrapR]),i.texParameteri(I,i.TEXTURE_MAG_FILTER,Kt[w.magFilter]),i.texParameteri(I,i.TEXTURE_MIN_FILTER,Kt[w.minFilter]),w.compareFunction&&(i.texParameteri(I,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(I,i.TEXTURE_COMPARE_FUNC,Ft[w.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===Pn||w.minFilter!==Pa&&w.minFilter!==ws||w.type===wi&&t.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){let $=t.get("EXT_texture_filter_anisotropic");i.texParameterf(I,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function le(I,w){let $=!1;I.__webglInit===void 0&&(I.__webglInit=!0,w.addEventListener("dispose",P),N(w));let pt=w.source,at=f.get(pt);at===void 0&&(at={},f.set(pt,at));let yt=K(w);if(yt!==I.__cacheKey){at[yt]===void 0&&(at[yt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,$=!0),at[yt].usedTimes++;let St=at[I.__cacheKey];St!==void 0&&(at[I.__cacheKey].usedTimes--,St.usedTimes===0&&V(w)),I.__cacheKey=yt,I.__webglTexture=at[yt].texture}return $}function ne(I,w,$){return Math.floor(Math.floor(I/$)/w)}function Ne(I,w,$,pt){let yt=I.updateRanges;if(yt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,w.width,w.height,$,pt,w.data);else{yt.sort((F,rt)=>F.start-rt.start);let St=0;for(let F=1;F<yt.length;F++){let rt=yt[St],it=yt[F],Tt=rt.start+rt.count,vt=ne(it.start,w.width,4),bt=ne(rt.start,w.width,4);it.start<=Tt+1&&vt===bt&&ne(it.start+it.count-1,w.width,4)===vt?rt.count=Math.max(rt.count,it.start+it.count-rt.start):(++St,yt[St]=it)}yt.length=St+1;let nt=e.getParameter(i.UNPACK_ROW_LENGTH),st=e.getParameter(i.UNPACK_SKIP_PIXELS),xt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,w.width);for(let F=0,rt=yt.length;F<rt;F++){let it=yt[F],Tt=Math.floor(it.start/4),vt=Math.ceil(it.count/4),bt=Tt%w.width,Ht=Math.floor(Tt/w.width),Qt=vt,dt=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(i.UNPACK_SKIP_ROWS,Ht),e.texSubImage2D(i.TEXTURE_2D,0,bt,Ht,Qt,dt,$,pt,w.data)}I.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,nt),e.pixelStorei(i.UNPACK_SKIP_PIXELS,st),e.pixelStorei(i.UNPACK_SKIP_ROWS,xt)}}function Ue(I,w,$){let pt=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(pt=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(pt=i.TEXTURE_3D);let at=le(I,w),yt=w.source;e.bindTexture(pt,I.__webglTexture,i.TEXTURE0+$);let St=n.get(yt);if(yt.version!==St.__version||at===!0){if(e.activeTexture(i.TEXTURE0+$),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let dt=ye.getPrimaries(ye.workingColorSpace),kt=w.colorSpace===Es?null:ye.getPrimaries(w.colorSpace),te=w.colorSpace===Es||dt===kt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,te)}e.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment);let st=v(w.image,!1,s.maxTextureSize);st=Gt(w,st);let xt=r.convert(w.format,w.colorSpace),F=r.convert(w.type),rt=M(w.internalFormat,xt,F,w.normalized,w.colorSpace,w.isVideoTexture);ce(pt,w);let it,Tt=w.mipmaps,vt=w.isVideoTexture!==!0,bt=St.__version===void 0||at===!0,Ht=yt.dataReady,Qt=b(w,st);if(w.isDepthTexture)rt=_(w.format===Ts,w.type),bt&&(vt?e.texStorage2D(i.TEXTURE_2D,1,rt,st.width,st.height):e.texImage2D(i.TEXTURE_2D,0,rt,st.width,st.height,0,xt,F,null));else if(w.isDataTexture)if(Tt.length>0){vt&&bt&&e.texStorage2D(i.TEXTURE_2D,Qt,rt,Tt[0].width,Tt[0].height);for(let dt=0,kt=Tt.length;dt<kt;dt++)it=Tt[dt],vt?Ht&&e.texSubImage2D(i.TEXTURE_2D,dt,0,0,it.width,it.height,xt,F,it.data):e.texImage2D(i.TEXTURE_2D,dt,rt,it.width,it.height,0,xt,F,it.data);w.generateMipmaps=!1}else vt?(bt&&e.texStorage2D(i.TEXTURE_2D,Qt,rt,st.width,st.height),Ht&&Ne(w,st,xt,F)):e.texImage2D(i.TEXTURE_2D,0,rt,st.width,st.height,0,xt,F,st.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){vt&&bt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Qt,rt,Tt[0].width,Tt[0].height,st.depth);for(let dt=0,kt=Tt.length;dt<kt;dt++)if(it=Tt[dt],w.format!==_i)if(xt!==null)if(vt){if(Ht)if(w.layerUpdates.size>0){let te=Dd(it.width,it.height,w.format,w.type);for(let Rt of w.layerUpdates){let he=it.data.subarray(Rt*te/it.data.BYTES_PER_ELEMENT,(Rt+1)*te/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,dt,0,0,Rt,it.width,it.height,1,xt,he)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,dt,0,0,0,it.width,it.height,st.depth,xt,it.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,dt,rt,it.width,it.height,st.depth,0,it.data,0,0);else Zt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else vt?Ht&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,dt,0,0,0,it.width,it.height,st.depth,xt,F,it.data):e.texImage3D(i.TEXTURE_2D_ARRAY,dt,rt,it.width,it.height,st.depth,0,xt,F,it.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{vt&&bt&&e.texStorage2D(i.TEXTURE_2D,Qt,rt,Tt[0].width,Tt[0].height);for(let dt=0,kt=Tt.length;dt<kt;dt++)it=Tt[dt],w.format!==_i?xt!==null?vt?Ht&&e.compressedTexSubImage2D(i.TEXTURE_2D,dt,0,0,it.width,it.height,xt,it.data):e.compressedTexImage2D(i.TEXTURE_2D,dt,rt,it.width,it.height,0,it.data):Zt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):vt?Ht&&e.texSubImage2D(i.TEXTURE_2D,dt,0,0,it.width,it.height,xt,F,it.data):e.texImage2D(i.TEXTURE_2D,dt,rt,it.width,it.height,0,xt,F,it.data)}else if(w.isDataArrayTexture)if(vt){if(bt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Qt,rt,st.width,st.height,st.depth),Ht)if(w.layerUpdates.size>0){let dt=Dd(st.width,st.height,w.format,w.type);for(let kt of w.layerUpdates){let te=st.data.subarray(kt*dt/st.data.BYTES_PER_ELEMENT,(kt+1)*dt/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,kt,st.width,st.height,1,xt,F,te)}w.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,xt,F,st.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,rt,st.width,st.height,st.depth,0,xt,F,st.data);else if(w.isData3DTexture)vt?(bt&&e.texStorage3D(i.TEXTURE_3D,Qt,rt,st.width,st.height,st.depth),Ht&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,xt,F,st.data)):e.texImage3D(i.TEXTURE_3D,0,rt,st.width,st.height,st.depth,0,xt,F,st.data);else if(w.isFramebufferTexture){if(bt)if(vt)e.texStorage2D(i.TEXTURE_2D,Qt,rt,st.width,st.height);else{let dt=st.width,kt=st.height;for(let te=0;te<Qt;te++)e.texImage2D(i.TEXTURE_2D,te,rt,dt,kt,0,xt,F,null),dt>>=1,kt>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in i){let dt=i.canvas;if(dt.hasAttribute("layoutsubtree")||dt.setAttribute("layoutsubtree","true"),st.parentNode!==dt){dt.appendChild(st),d.add(w),dt.onpaint=kt=>{let te=kt.changedElements;for(let Rt of d)te.includes(Rt.image)&&(Rt.needsUpdate=!0)},dt.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,st);else{let te=i.RGBA,Rt=i.RGBA,he=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,te,Rt,he,st)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Tt.length>0){if(vt&&bt){let dt=Yt(Tt[0]);e.texStorage2D(i.TEXTURE_2D,Qt,rt,dt.width,dt.height)}for(let dt=0,kt=Tt.length;dt<kt;dt++)it=Tt[dt],vt?Ht&&e.texSubImage2D(i.TEXTURE_2D,dt,0,0,xt,F,it):e.texImage2D(i.TEXTURE_2D,dt,rt,xt,F,it);w.generateMipmaps=!1}else if(vt){if(bt){let dt=Yt(st);e.texStorage2D(i.TEXTURE_2D,Qt,rt,dt.width,dt.height)}Ht&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,xt,F,st)}else e.texImage2D(i.TEXTURE_2D,0,rt,xt,F,st);A(w)&&w.mipmapsAutoUpdate===!0&&S(pt),St.__version=yt.version,w.onUpdate&&w.onUpdate(w)}I.__version=w.version}function rn(I,w,$){if(w.image.length!==6)return;let pt=le(I,w),at=w.source;e.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+$);let yt=n.get(at);if(at.version!==yt.__version||pt===!0){e.activeTexture(i.TEXTURE0+$);let St=ye.getPrimaries(ye.workingColorSpace),nt=w.colorSpace===Es?null:ye.getPrimaries(w.colorSpace),st=w.colorSpace===Es||St===nt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let xt=w.isCompressedTexture||w.image[0].isCompressedTexture,F=w.image[0]&&w.image[0].isDataTexture,rt=[];for(let Rt=0;Rt<6;Rt++)!xt&&!F?rt[Rt]=v(w.image[Rt],!0,s.maxCubemapSize):rt[Rt]=F?w.image[Rt].image:w.image[Rt],rt[Rt]=Gt(w,rt[Rt]);let it=rt[0],Tt=r.convert(w.format,w.colorSpace),vt=r.convert(w.type),bt=M(w.internalFormat,Tt,vt,w.normalized,w.colorSpace),Ht=w.isVideoTexture!==!0,Qt=yt.__version===void 0||pt===!0,dt=at.dataReady,kt=b(w,it);ce(i.TEXTURE_CUBE_MAP,w);let te;if(w.isDepthTexture){if(bt=_(w.format===Ts,w.type),Qt)if(Ht)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,bt,it.width,it.height);else for(let Rt=0;Rt<6;Rt++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,bt,it.width,it.height,0,Tt,vt,null)}else if(xt){Ht&&Qt&&e.texStorage2D(i.TEXTURE_CUBE_MAP,kt,bt,it.width,it.height);for(let Rt=0;Rt<6;Rt++){te=rt[Rt].mipmaps;for(let he=0;he<te.length;he++){let Ve=te[he];w.format!==_i?Tt!==null?Ht?dt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he,0,0,Ve.width,Ve.height,Tt,Ve.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he,bt,Ve.width,Ve.height,0,Ve.data):Zt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ht?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he,0,0,Ve.width,Ve.height,Tt,vt,Ve.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he,bt,Ve.width,Ve.height,0,Tt,vt,Ve.data)}}}else{if(te=w.mipmaps,Ht&&Qt){te.length>0&&kt++;let Rt=Yt(rt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,kt,bt,Rt.width,Rt.height)}for(let Rt=0;Rt<6;Rt++)if(F){Ht?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,rt[Rt].width,rt[Rt].height,Tt,vt,rt[Rt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,bt,rt[Rt].width,rt[Rt].height,0,Tt,vt,rt[Rt].data);for(let he=0;he<te.length;he++){let qn=te[he].image[Rt].image;Ht?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he+1,0,0,qn.width,qn.height,Tt,vt,qn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he+1,bt,qn.width,qn.height,0,Tt,vt,qn.data)}}else{Ht?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,Tt,vt,rt[Rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,bt,Tt,vt,rt[Rt]);for(let he=0;he<te.length;he++){let Ve=te[he];Ht?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he+1,0,0,Tt,vt,Ve.image[Rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he+1,bt,Tt,vt,Ve.image[Rt])}}}A(w)&&w.mipmapsAutoUpdate===!0&&S(i.TEXTURE_CUBE_MAP),yt.__version=at.version,w.onUpdate&&w.onUpdate(w)}I.__version=w.version}function Fe(I,w,$,pt,at,yt){let St=r.convert($.format,$.colorSpace),nt=r.convert($.type),st=M($.internalFormat,St,nt,$.normalized,$.colorSpace),xt=n.get(w),F=n.get($);if(F.__renderTarget=w,!xt.__hasExternalTextures){let rt=Math.max(1,w.width>>yt),it=Math.max(1,w.height>>yt);at===i.TEXTURE_3D||at===i.TEXTURE_2D_ARRAY?e.texImage3D(at,yt,st,rt,it,w.depth,0,St,nt,null):e.texImage2D(at,yt,st,rt,it,0,St,nt,null)}e.bindFramebuffer(i.FRAMEBUFFER,I),wt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pt,at,F.__webglTexture,0,ae(w)):(at===i.TEXTURE_2D||at>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,pt,at,F.__webglTexture,yt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Mn(I,w,$){if(i.bindRenderbuffer(i.RENDERBUFFER,I),w.depthBuffer){let pt=w.depthTexture,at=pt&&pt.isDepthTexture?pt.type:null,yt=_(w.stencilBuffer,at),St=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;wt(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ae(w),yt,w.width,w.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,ae(w),yt,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,yt,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,St,i.RENDERBUFFER,I)}else{let pt=w.textures;for(let at=0;at<pt.length;at++){let yt=pt[at],St=r.convert(yt.format,yt.colorSpace),nt=r.convert(yt.type),st=M(yt.internalFormat,St,nt,yt.normalized,yt.colorSpace);wt(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ae(w),st,w.width,w.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,ae(w),st,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,st,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Se(I,w,$){let pt=w.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,I),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=n.get(w.depthTexture);at.__renderTarget=w;let yt=pt?w.depthTexture.image[0]:w.depthTexture.image;(!at.__webglTexture||yt.width!==w.width||yt.height!==w.height)&&(yt.width=w.width,yt.height=w.height,w.depthTexture.needsUpdate=!0),pt?mt(w.depthTexture,0):ut(w.depthTexture,0);let St=at.__webglTexture,nt=ae(w),st=pt?i.TEXTURE_CUBE_MAP_POSITIVE_X+$:i.TEXTURE_2D,xt=w.depthTexture.format===Ts?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(w.depthTexture.format===vs)wt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,xt,st,St,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,xt,st,St,0);else if(w.depthTexture.format===Ts)wt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,xt,st,St,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,xt,st,St,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function fn(I){let w=n.get(I),$=I.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==I.depthTexture){let pt=I.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),pt){let at=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,pt.removeEventListener("dispose",at)};pt.addEventListener("dispose",at),w.__depthDisposeCallback=at}w.__boundDepthTexture=pt}if(I.depthTexture&&!w.__autoAllocateDepthBuffer)if($)for(let pt=0;pt<6;pt++)Se(w.__webglFramebuffer[pt],I,pt);else I.texture.mipmaps.length>0?Se(w.__webglFramebuffer[0],I,0):Se(w.__webglFramebuffer,I,0);else if($){w.__webglDepthbuffer=[];for(let pt=0;pt<6;pt++)if(e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[pt]),w.__webglDepthbuffer[pt]===void 0)w.__webglDepthbuffer[pt]=i.createRenderbuffer(),Mn(w.__webglDepthbuffer[pt],I,!1);else{let at=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=w.__webglDepthbuffer[pt];i.bindRenderbuffer(i.RENDERBUFFER,yt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,yt)}}else if(I.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),Mn(w.__webglDepthbuffer,I,!1);else{let at=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,yt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,yt)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Je(I,w,$){let pt=n.get(I);w!==void 0&&Fe(pt.__webglFramebuffer,I,I.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),$!==void 0&&fn(I)}function on(I){let w=I.texture,$=n.get(I),pt=n.get(w);I.addEventListener("dispose",O),N(I);let at=I.textures,yt=I.isWebGLCubeRenderTarget===!0,St=at.length>1;if(St||(pt.__webglTexture===void 0&&(pt.__webglTexture=i.createTexture()),pt.__version=w.version,o.memory.textures++),yt){$.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(w.mipmaps.length>0){$.__webglFramebuffer[nt]=[];for(let st=0;st<w.mipmaps.length;st++)$.__webglFramebuffer[nt][st]=i.createFramebuffer()}else $.__webglFramebuffer[nt]=i.createFramebuffer()}else{if(w.mipmaps.length>0){$.__webglFramebuffer=[];for(let nt=0;nt<w.mipmaps.length;nt++)$.__webglFramebuffer[nt]=i.createFramebuffer()}else $.__webglFramebuffer=i.createFramebuffer();if(St)for(let nt=0,st=at.length;nt<st;nt++){let xt=n.get(at[nt]);xt.__webglTexture===void 0&&(xt.__webglTexture=i.createTexture(),o.memory.textures++)}if(I.samples>0&&wt(I)===!1){$.__webglMultisampledFramebuffer=i.createFramebuffer(),$.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let nt=0;nt<at.length;nt++){let st=at[nt];$.__webglColorRenderbuffer[nt]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,$.__webglColorRenderbuffer[nt]);let xt=r.convert(st.format,st.colorSpace),F=r.convert(st.type),rt=M(st.internalFormat,xt,F,st.normalized,st.colorSpace,I.isXRRenderTarget===!0),it=ae(I);i.renderbufferStorageMultisample(i.RENDERBUFFER,it,rt,I.width,I.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+nt,i.RENDERBUFFER,$.__webglColorRenderbuffer[nt])}i.bindRenderbuffer(i.RENDERBUFFER,null),I.depthBuffer&&($.__webglDepthRenderbuffer=i.createRenderbuffer(),Mn($.__webglDepthRenderbuffer,I,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(yt){e.bindTexture(i.TEXTURE_CUBE_MAP,pt.__webglTexture),ce(i.TEXTURE_CUBE_MAP,w);for(let nt=0;nt<6;nt++)if(w.mipmaps.length>0)for(let st=0;st<w.mipmaps.length;st++)Fe($.__webglFramebuffer[nt][st],I,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,st);else Fe($.__webglFramebuffer[nt],I,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);A(w)?S(i.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}else if(St){for(let nt=0,st=at.length;nt<st;nt++){let xt=at[nt],F=n.get(xt),rt=i.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(rt=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(rt,F.__webglTexture),ce(rt,xt),Fe($.__webglFramebuffer,I,xt,i.COLOR_ATTACHMENT0+nt,rt,0),A(xt)&&S(rt)}e.unbindTexture()}else{let nt=i.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(nt=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(nt,pt.__webglTexture),ce(nt,w),w.mipmaps.length>0)for(let st=0;st<w.mipmaps.length;st++)Fe($.__webglFramebuffer[st],I,w,i.COLOR_ATTACHMENT0,nt,st);else Fe($.__webglFramebuffer,I,w,i.COLOR_ATTACHMENT0,nt,0);A(w)?S(nt):w.mipmaps.length>0&&i.texParameteri(nt,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}I.depthBuffer&&fn(I)}function B(I){let w=I.textures;for(let $=0,pt=w.length;$<pt;$++){let at=w[$];if(A(at)&&at.mipmapsAutoUpdate===!0){let yt=C(I),St=n.get(at).__webglTexture;e.bindTexture(yt,St),S(yt),e.unbindTexture()}}}let Ct=[];function Jt(I){if(I.samples>0){if(wt(I)===!1){let w=I.textures,$=I.width,pt=I.height,at=i.COLOR_BUFFER_BIT,yt=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,St=n.get(I),nt=w.length>1;if(nt)for(let xt=0;xt<w.length;xt++)e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+xt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+xt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let xt=0;xt<w.length;xt++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(at|=i.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(at|=i.STENCIL_BUFFER_BIT)),nt){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,St.__webglColorRenderbuffer[xt]);let F=n.get(w[xt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,F,0)}i.blitFramebuffer(0,0,$,pt,0,0,$,pt,at,i.NEAREST),c===!0&&(Ct.length=0,Ct.push(i.COLOR_ATTACHMENT0+xt),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&Ct.push(yt),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ct))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),nt)for(let xt=0;xt<w.length;xt++){e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+xt,i.RENDERBUFFER,St.__webglColorRenderbuffer[xt]);let F=n.get(w[xt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+xt,i.TEXTURE_2D,F,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&c){let w=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function ae(I){return Math.min(s.maxSamples,I.samples)}function wt(I){let w=n.get(I);return I.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Be(I){let w=o.render.frame;h.get(I)!==w&&(h.set(I,w),I.update())}function Gt(I,w){let $=I.colorSpace,pt=I.format,at=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||$!==aa&&$!==Es&&(ye.getTransfer($)===Pe?(pt!==_i||at!==ii)&&Zt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):se("WebGLTextures: Unsupported texture color space:",$)),w}function Yt(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(l.width=I.naturalWidth||I.width,l.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(l.width=I.displayWidth,l.height=I.displayHeight):(l.width=I.width,l.height=I.height),l}this.allocateTextureUnit=ot,this.resetTextureUnits=k,this.getTextureUnits=Q,this.setTextureUnits=lt,this.setTexture2D=ut,this.setTexture2DArray=ft,this.setTexture3D=_t,this.setTextureCube=mt,this.rebindTextures=Je,this.setupRenderTarget=on,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Jt,this.setupDepthRenderbuffer=fn,this.setupFrameBufferTexture=Fe,this.useMultisampledRTT=wt,this.dispose=H}function A1(i,t){function e(n,s=Es){let r,o=ye.getTransfer(s);if(n===ii)return i.UNSIGNED_BYTE;if(n===Rc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Cc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===xd)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===vd)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===gd)return i.BYTE;if(n===_d)return i.SHORT;if(n===Eo)return i.UNSIGNED_SHORT;if(n===Ac)return i.INT;if(n===Fi)return i.UNSIGNED_INT;if(n===wi)return i.FLOAT;if(n===Oi)return i.HALF_FLOAT;if(n===yd)return i.ALPHA;if(n===Sd)return i.RGB;if(n===_i)return i.RGBA;if(n===vs)return i.DEPTH_COMPONENT;if(n===Ts)return i.DEPTH_STENCIL;if(n===Pc)return i.RED;if(n===Ic)return i.RED_INTEGER;if(n===Qs)return i.RG;if(n===Lc)return i.RG_INTEGER;if(n===Dc)return i.RGBA_INTEGER;if(n===Ia||n===La||n===Da||n===Na)if(o===Pe)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ia)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===La)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Da)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Na)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ia)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===La)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Da)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Na)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Nc||n===Uc||n===Fc||n===Oc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Nc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Uc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Fc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Oc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Bc||n===kc||n===zc||n===Vc||n===Gc||n===Ua||n===Hc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Bc||n===kc)return o===Pe?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===zc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Vc)return r.COMPRESSED_R11_EAC;if(n===Gc)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ua)return r.COMPRESSED_RG11_EAC;if(n===Hc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Wc||n===Xc||n===qc||n===Yc||n===$c||n===Zc||n===Jc||n===Kc||n===jc||n===Qc||n===th||n===eh||n===nh||n===ih)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Wc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Xc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===qc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Yc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===$c)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Zc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Jc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Kc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===jc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Qc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===th)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===eh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===nh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===ih)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===sh||n===rh||n===oh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===sh)return o===Pe?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===rh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===oh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===ah||n===lh||n===Fa||n===ch)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===ah)return r.COMPRESSED_RED_RGTC1_EXT;if(n===lh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Fa)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===ch)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Mr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var R1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,C1=`
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

}`,Gd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new va(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new Ki({vertexShader:R1,fragmentShader:C1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Hn(new _r(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Hd=class extends Ui{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,h=null,d=null,u=null,f=null,p=null,y=typeof XRWebGLBinding<"u",m=new Gd,g={},v=e.getContextAttributes(),A=null,S=null,C=[],M=[],_=new ee,b=null,N=null,R=new jn;R.viewport=new $e;let P=new jn;P.viewport=new $e;let O=[R,P],z=new Mc,D=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(K){let ut=C[K];return ut===void 0&&(ut=new go,C[K]=ut),ut.getTargetRaySpace()},this.getControllerGrip=function(K){let ut=C[K];return ut===void 0&&(ut=new go,C[K]=ut),ut.getGripSpace()},this.getHand=function(K){let ut=C[K];return ut===void 0&&(ut=new go,C[K]=ut),ut.getHandSpace()};function W(K){let ut=M.indexOf(K.inputSource);if(ut===-1)return;let ft=C[ut];ft!==void 0&&(ft.update(K.inputSource,K.frame,l||o),ft.dispatchEvent({type:K.type,data:K.inputSource}))}function V(){s.removeEventListener("select",W),s.removeEventListener("selectstart",W),s.removeEventListener("selectend",W),s.removeEventListener("squeeze",W),s.removeEventListener("squeezestart",W),s.removeEventListener("squeezeend",W),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",ht);for(let K=0;K<C.length;K++){let ut=M[K];ut!==null&&(M[K]=null,C[K].disconnect(ut))}D=null,H=null,m.reset();for(let K in g)delete g[K];if(t.setRenderTarget(A),f=null,u=null,d=null,s=null,S=null,ot.stop(),n.isPresenting=!1,t.setPixelRatio(b),t.setSize(_.width,_.height,!1),N!==null){let K=N.camera;K.fov=N.fov,K.zoom=N.zoom,K.updateProjectionMatrix(),N=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(K){r=K,n.isPresenting===!0&&Zt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(K){a=K,n.isPresenting===!0&&Zt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(K){l=K},this.getBaseLayer=function(){return u!==null?u:f},this.getBinding=function(){return d===null&&y&&(d=new XRWebGLBinding(s,e)),d},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(K){if(s=K,s!==null){if(A=t.getRenderTarget(),s.addEventListener("select",W),s.addEventListener("selectstart",W),s.addEventListener("selectend",W),s.addEventListener("squeeze",W),s.addEventListener("squeezestart",W),s.addEventListener("squeezeend",W),s.addEventListener("end",V),s.addEventListener("inputsourceschange",ht),v.xrCompatible!==!0&&await e.makeXRCompatible(),b=t.getPixelRatio(),t.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let ft=null,_t=null,mt=null;v.depth&&(mt=v.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,ft=v.stencil?Ts:vs,_t=v.stencil?Mr:Fi);let Bt={colorFormat:e.RGBA8,depthFormat:mt,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(Bt),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),S=new mi(u.textureWidth,u.textureHeight,{format:_i,type:ii,depthTexture:new bs(u.textureWidth,u.textureHeight,_t,void 0,void 0,void 0,void 0,void 0,void 0,ft),stencilBuffer:v.stencil,colorSpace:t.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let ft={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,ft),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),S=new mi(f.framebufferWidth,f.framebufferHeight,{format:_i,type:ii,colorSpace:t.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),ot.setContext(s),ot.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ht(K){for(let ut=0;ut<K.removed.length;ut++){let ft=K.removed[ut],_t=M.indexOf(ft);_t>=0&&(M[_t]=null,C[_t].disconnect(ft))}for(let ut=0;ut<K.added.length;ut++){let ft=K.added[ut],_t=M.indexOf(ft);if(_t===-1){for(let Bt=0;Bt<C.length;Bt++)if(Bt>=M.length){M.push(ft),_t=Bt;break}else if(M[Bt]===null){M[Bt]=ft,_t=Bt;break}if(_t===-1)break}let mt=C[_t];mt&&mt.connect(ft)}}function J(K,ut){ut===null?K.matrixWorld.copy(K.matrix):K.matrixWorld.multiplyMatrices(ut.matrixWorld,K.matrix),K.matrixWorldInverse.copy(K.matrixWorld).invert()}this.updateCamera=function(K){if(s===null)return;let ut=K.near,ft=K.far;m.texture!==null&&(m.depthNear>0&&(ut=m.depthNear),m.depthFar>0&&(ft=m.depthFar)),z.near=P.near=R.near=ut,z.far=P.far=R.far=ft,(D!==z.near||H!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),D=z.near,H=z.far),z.layers.mask=K.layers.mask|6,R.layers.mask=z.layers.mask&-5,P.layers.mask=z.layers.mask&-3;let _t=K.parent,mt=z.cameras;J(z,_t);for(let Bt=0;Bt<mt.length;Bt++)J(mt[Bt],_t);z.projectionMatrix.copy(R.projectionMatrix),z.projectionMatrixInverse.copy(R.projectionMatrixInverse),N===null&&K.isPerspectiveCamera&&(N={camera:K,fov:K.fov,zoom:K.zoom}),k(K,z,_t)};function k(K,ut,ft){ft===null?K.matrix.copy(ut.matrixWorld):(K.matrix.copy(ft.matrixWorld),K.matrix.invert(),K.matrix.multiply(ut.matrixWorld)),K.matrix.decompose(K.position,K.quaternion,K.scale),K.updateMatrixWorld(!0),K.projectionMatrix.copy(ut.projectionMatrix),K.projectionMatrixInverse.copy(ut.projectionMatrixInverse),K.isPerspectiveCamera&&(K.fov=po*2*Math.atan(1/K.projectionMatrix.elements[5]),K.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(u===null&&f===null))return c},this.setFoveation=function(K){c=K,u!==null&&(u.fixedFoveation=K),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=K)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(z)},this.getCameraTexture=function(K){return g[K]};let Q=null;function lt(K,ut){if(h=ut.getViewerPose(l||o),p=ut,h!==null){let ft=h.views;f!==null&&(t.setRenderTargetFramebuffer(S,f.framebuffer),t.setRenderTarget(S));let _t=!1;ft.length!==z.cameras.length&&(z.cameras.length=0,_t=!0);for(let Ft=0;Ft<ft.length;Ft++){let ce=ft[Ft],le=null;if(f!==null)le=f.getViewport(ce);else{let Ne=d.getViewSubImage(u,ce);le=Ne.viewport,Ft===0&&(t.setRenderTargetTextures(S,Ne.colorTexture,Ne.depthStencilTexture),t.setRenderTarget(S))}let ne=O[Ft];ne===void 0&&(ne=new jn,ne.layers.enable(Ft),ne.viewport=new $e,O[Ft]=ne),ne.matrix.fromArray(ce.transform.matrix),ne.matrix.decompose(ne.position,ne.quaternion,ne.scale),ne.projectionMatrix.fromArray(ce.projectionMatrix),ne.projectionMatrixInverse.copy(ne.projectionMatrix).invert(),ne.viewport.set(le.x,le.y,le.width,le.height),Ft===0&&(z.matrix.copy(ne.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),_t===!0&&z.cameras.push(ne)}let mt=s.enabledFeatures;if(mt&&mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){d=n.getBinding();let Ft=d.getDepthInformation(ft[0]);Ft&&Ft.isValid&&Ft.texture&&m.init(Ft,s.renderState)}if(mt&&mt.includes("camera-access")&&y){t.state.unbindTexture(),d=n.getBinding();for(let Ft=0;Ft<ft.length;Ft++){let ce=ft[Ft].camera;if(ce){let le=g[ce];le||(le=new va,g[ce]=le);let ne=d.getCameraImage(ce);le.sourceTexture=ne}}}}for(let ft=0;ft<C.length;ft++){let _t=M[ft],mt=C[ft];_t!==null&&mt!==void 0&&mt.update(_t,ut,l||o)}Q&&Q(K,ut),ut.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ut}),p=null}let ot=new u0;ot.setAnimationLoop(lt),this.setAnimationLoop=function(K){Q=K},this.dispose=function(){}}},P1=new Ae,S0=new re;S0.set(-1,0,0,0,1,0,0,0,1);function I1(i,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,Pd(i)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,v,A,S){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),d(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),u(m,g),g.isMeshPhysicalMaterial&&f(m,g,S)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),y(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?c(m,g,v,A):g.isSpriteMaterial?l(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===ti&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===ti&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let v=t.get(g),A=v.envMap,S=v.envMapRotation;A&&(m.envMap.value=A,m.envMapRotation.value.setFromMatrix4(P1.makeRotationFromEuler(S)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(S0),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function c(m,g,v,A){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*v,m.scale.value=A*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function l(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function d(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function u(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,v){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===ti&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function y(m,g){let v=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function L1(i,t,e,n){let s={},r={};function o(v,A){let S=A.program;n.uniformBlockBinding(v,S,s[v.id])}function a(v,A){let S=s[v.id];S===void 0&&(p(v),S=c(v),s[v.id]=S,v.addEventListener("dispose",m));let C=A.program;n.updateUBOMapping(v,C);let M=t.render.frame;r[v.id]!==M&&(l(v),r[v.id]=M)}function c(v){let A=i.createBuffer(),S=v.__size,C=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,S,C),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function l(v){let A=s[v.id],S=v.uniforms,C=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let M=0,_=S.length;M<_;M++){let b=S[M];if(Array.isArray(b))for(let N=0,R=b.length;N<R;N++)h(b[N],M,N,C);else h(b,M,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(v,A,S,C){if(u(v,A,S,C)===!0){let M=v.__offset,_=v.value;if(Array.isArray(_)){let b=0;for(let N=0;N<_.length;N++){let R=_[N],P=y(R,!0);d(R,v.__data,b),b+=P.storage/Float32Array.BYTES_PER_ELEMENT}}else d(_,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,M,v.__data)}}function d(v,A,S){typeof v=="number"||typeof v=="boolean"?A[S]=v:v.isMatrix3?(A[S]=v.elements[0],A[S+1]=v.elements[1],A[S+2]=v.elements[2],A[S+3]=0,A[S+4]=v.elements[3],A[S+5]=v.elements[4],A[S+6]=v.elements[5],A[S+7]=0,A[S+8]=v.elements[6],A[S+9]=v.elements[7],A[S+10]=v.elements[8],A[S+11]=0):ArrayBuffer.isView(v)?A.set(v.subarray(0,A.length-S),S):v.toArray(A,S)}function u(v,A,S,C){let M=v.value,_=A+"_"+S;if(Array.isArray(M)){C[_]===void 0&&(C[_]=[]);let b=C[_],N=!1;for(let R=0;R<M.length;R++)f(M[R],b,R)===!0&&(N=!0);return N}return f(M,C,_)}function f(v,A,S){if(A[S]===void 0)return typeof v=="number"||typeof v=="boolean"?A[S]=v:ArrayBuffer.isView(v)?A[S]=v.slice():A[S]=v.clone(),!0;{let C=A[S];if(typeof v=="number"||typeof v=="boolean"){if(C!==v)return A[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(C.equals(v)===!1)return C.copy(v),!0}}return!1}function p(v){let A=v.uniforms,S=0,C=16;for(let _=0,b=A.length;_<b;_++){let N=Array.isArray(A[_])?A[_]:[A[_]];for(let R=0,P=N.length;R<P;R++){let O=N[R],z=Array.isArray(O.value)?O.value:[O.value],D=Array.isArray(A[_])||Array.isArray(O.value),H=S;for(let V=0,ht=z.length;V<ht;V++){let J=z[V],k=y(J,D),Q=S%C,lt=Q%k.boundary,ot=Q+lt;S+=lt,ot!==0&&C-ot<k.storage&&(S+=C-ot),V===0&&(H=S),S+=k.storage}let W=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new W((S-H)/Float32Array.BYTES_PER_ELEMENT),O.__offset=H}}let M=S%C;return M>0&&(S+=C-M),v.__size=S,v.__cache={},this}function y(v,A){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?Zt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):Zt("WebGLRenderer: Unsupported uniform value type.",v),A===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function m(v){let A=v.target;A.removeEventListener("dispose",m),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function g(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:g}}var D1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Qi=null;function N1(){return Qi===null&&(Qi=new gr(D1,16,16,Qs,Oi),Qi.name="DFG_LUT",Qi.minFilter=Ln,Qi.magFilter=Ln,Qi.wrapS=Zi,Qi.wrapT=Zi,Qi.generateMipmaps=!1,Qi.needsUpdate=!0),Qi}var gh=class{constructor(t={}){let{canvas:e=Ng(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:f=ii}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let y=f,m=new Set([Dc,Lc,Ic]),g=new Set([ii,Fi,Eo,Mr,Rc,Cc]),v=new Uint32Array(4),A=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},C=null,M=null,_=[],b=[],N=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ji,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let R=this,P=!1,O=null,z=null,D=null,H=null;this._outputColorSpace=zn;let W=0,V=0,ht=null,J=-1,k=null,Q=new $e,lt=new $e,ot=null,K=new fe(0),ut=0,ft=e.width,_t=e.height,mt=1,Bt=null,Kt=null,Ft=new $e(0,0,ft,_t),ce=new $e(0,0,ft,_t),le=!1,ne=new Xs,Ne=new sc,Ue=!1,rn=!1,Fe=new Ae,Mn=new q,Se=new $e,fn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Je=!1;function on(){return ht===null?mt:1}let B=n;function Ct(E,G){return e.getContext(E,G)}let Jt,ae,wt,Be,Gt,Yt,I,w,$,pt,at,yt,St,nt,st,xt,F,rt,it,Tt,vt,bt,Ht;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",kt,!1),e.addEventListener("webglcontextrestored",te,!1),e.addEventListener("webglcontextcreationerror",Rt,!1),B===null){let G="webgl2";if(B=Ct(G,E),B===null)throw Ct(G)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Qt()}catch(E){throw e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",te,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),se("WebGLRenderer: "+E.message),E}function Qt(){Jt=new Xb(B),Jt.init(),vt=new A1(B,Jt),ae=new Nb(B,Jt,t,vt),wt=new T1(B,Jt),ae.reversedDepthBuffer&&u&&wt.buffers.depth.setReversed(!0),z=B.createFramebuffer(),D=B.createFramebuffer(),H=B.createFramebuffer(),Be=new $b(B),Gt=new u1,Yt=new E1(B,Jt,wt,Gt,ae,vt,Be),I=new Wb(R),w=new Jy(B),bt=new Lb(B,w),$=new qb(B,w,Be,bt),pt=new Jb(B,$,w,bt,Be),rt=new Zb(B,ae,Yt),st=new Ub(Gt),at=new h1(R,I,Jt,ae,bt,st),yt=new I1(R,Gt),St=new f1,nt=new v1(Jt),F=new Ib(R,I,wt,pt,p,c),xt=new w1(R,pt,ae),Ht=new L1(B,Be,ae,wt),it=new Db(B,Jt,Be),Tt=new Yb(B,Jt,Be),Be.programs=at.programs,R.capabilities=ae,R.extensions=Jt,R.properties=Gt,R.renderLists=St,R.shadowMap=xt,R.state=wt,R.info=Be}y!==ii&&(N=new jb(y,e.width,e.height,a,s,r));let dt=new Hd(R,B);this.xr=dt,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let E=Jt.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=Jt.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return mt},this.setPixelRatio=function(E){E!==void 0&&(mt=E,this.setSize(ft,_t,!1))},this.getSize=function(E){return E.set(ft,_t)},this.setSize=function(E,G,et=!0){if(dt.isPresenting){Zt("WebGLRenderer: Can't change size while VR device is presenting.");return}ft=E,_t=G,e.width=Math.floor(E*mt),e.height=Math.floor(G*mt),et===!0&&(e.style.width=E+"px",e.style.height=G+"px"),N!==null&&N.setSize(e.width,e.height),this.setViewport(0,0,E,G)},this.getDrawingBufferSize=function(E){return E.set(ft*mt,_t*mt).floor()},this.setDrawingBufferSize=function(E,G,et){ft=E,_t=G,mt=et,e.width=Math.floor(E*et),e.height=Math.floor(G*et),this.setViewport(0,0,E,G)},this.setEffects=function(E){if(y===ii){se("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let G=0;G<E.length;G++)if(E[G].isOutputPass===!0){Zt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(Q)},this.getViewport=function(E){return E.copy(Ft)},this.setViewport=function(E,G,et,Z){E.isVector4?Ft.set(E.x,E.y,E.z,E.w):Ft.set(E,G,et,Z),wt.viewport(Q.copy(Ft).multiplyScalar(on()).round())},this.getScissor=function(E){return E.copy(ce)},this.setScissor=function(E,G,et,Z){E.isVector4?ce.set(E.x,E.y,E.z,E.w):ce.set(E,G,et,Z),wt.scissor(lt.copy(ce).multiplyScalar(on()).round())},this.getScissorTest=function(){return le},this.setScissorTest=function(E){wt.setScissorTest(le=E)},this.setOpaqueSort=function(E){Bt=E},this.setTransparentSort=function(E){Kt=E},this.getClearColor=function(E){return E.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(E=!0,G=!0,et=!0){let Z=0;if(E){let j=!1;if(ht!==null){let Et=ht.texture.format;j=m.has(Et)}if(j){let Et=ht.texture.type,Pt=g.has(Et),At=F.getClearColor(),It=F.getClearAlpha(),Vt=At.r,ie=At.g,pe=At.b;Pt?(v[0]=Vt,v[1]=ie,v[2]=pe,v[3]=It,B.clearBufferuiv(B.COLOR,0,v)):(A[0]=Vt,A[1]=ie,A[2]=pe,A[3]=It,B.clearBufferiv(B.COLOR,0,A))}else Z|=B.COLOR_BUFFER_BIT}G&&(Z|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),et&&(Z|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&B.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),O=E},this.dispose=function(){e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",te,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),F.dispose(),St.dispose(),nt.dispose(),Yt.dispose(),Gt.dispose(),I.dispose(),pt.dispose(),$.dispose(),bt.dispose(),Ht.dispose(),at.dispose(),dt.dispose(),dt.removeEventListener("sessionstart",Va),dt.removeEventListener("sessionend",ki),es.stop()};function kt(E){E.preventDefault(),Ed("WebGLRenderer: Context Lost."),P=!0}function te(){Ed("WebGLRenderer: Context Restored."),P=!1;let E=Be.autoReset,G=xt.enabled,et=xt.autoUpdate,Z=xt.needsUpdate,j=xt.type;Qt(),Be.autoReset=E,xt.enabled=G,xt.autoUpdate=et,xt.needsUpdate=Z,xt.type=j}function Rt(E){se("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function he(E){let G=E.target;G.removeEventListener("dispose",he),Ve(G)}function Ve(E){qn(E),Gt.remove(E)}function qn(E){let G=Gt.get(E).programs;G!==void 0&&(G.forEach(function(et){at.releaseProgram(et)}),E.isShaderMaterial&&at.releaseShaderCache(E))}this.renderBufferDirect=function(E,G,et,Z,j,Et){G===null&&(G=fn);let Pt=j.isMesh&&j.matrixWorld.determinantAffine()<0,At=No(E,G,et,Z,j);wt.setMaterial(Z,Pt);let It=et.index,Vt=1;if(Z.wireframe===!0){if(It=$.getWireframeAttribute(et),It===void 0)return;Vt=2}let ie=et.drawRange,pe=et.attributes.position,zt=ie.start*Vt,me=(ie.start+ie.count)*Vt;Et!==null&&(zt=Math.max(zt,Et.start*Vt),me=Math.min(me,(Et.start+Et.count)*Vt)),It!==null?(zt=Math.max(zt,0),me=Math.min(me,It.count)):pe!=null&&(zt=Math.max(zt,0),me=Math.min(me,pe.count));let Ze=me-zt;if(Ze<0||Ze===1/0)return;bt.setup(j,Z,At,et,It);let Ie,Le=it;if(It!==null&&(Ie=w.get(It),Le=Tt,Le.setIndex(Ie)),j.isMesh)Z.wireframe===!0?(wt.setLineWidth(Z.wireframeLinewidth*on()),Le.setMode(B.LINES)):Le.setMode(B.TRIANGLES);else if(j.isLine){let pn=Z.linewidth;pn===void 0&&(pn=1),wt.setLineWidth(pn*on()),j.isLineSegments?Le.setMode(B.LINES):j.isLineLoop?Le.setMode(B.LINE_LOOP):Le.setMode(B.LINE_STRIP)}else j.isPoints?Le.setMode(B.POINTS):j.isSprite&&Le.setMode(B.TRIANGLES);if(j.isBatchedMesh)if(Jt.get("WEBGL_multi_draw"))Le.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let pn=j._multiDrawStarts,Ut=j._multiDrawCounts,an=j._multiDrawCount,xe=It?w.get(It).bytesPerElement:1,is=Gt.get(Z).currentProgram.getUniforms();for(let ln=0;ln<an;ln++)is.setValue(B,"_gl_DrawID",ln),Le.render(pn[ln]/xe,Ut[ln])}else if(j.isInstancedMesh)Le.renderInstances(zt,Ze,j.count);else if(et.isInstancedBufferGeometry){let pn=et._maxInstanceCount!==void 0?et._maxInstanceCount:1/0,Ut=Math.min(et.instanceCount,pn);Le.renderInstances(zt,Ze,Ut)}else Le.render(zt,Ze)};function Io(E,G,et,Z){O!==null&&E.isNodeMaterial&&O.setObject(Z,E),Ue===!0&&st.setState(E,et,!1),E.transparent===!0&&E.side===ni&&E.forceSinglePass===!1?(E.side=ti,E.needsUpdate=!0,zi(E,G,Z),E.side=js,E.needsUpdate=!0,zi(E,G,Z),E.side=ni):zi(E,G,Z)}this.compile=function(E,G,et=null){et===null&&(et=E),O!==null&&O.renderStart(E,G,et),M=nt.get(et),M.init(G),b.push(M),et.traverseVisible(function(j){j.isLight&&j.layers.test(G.layers)&&(M.pushLight(j),j.castShadow&&M.pushShadow(j))}),E!==et&&E.traverseVisible(function(j){j.isLight&&j.layers.test(G.layers)&&(M.pushLight(j),j.castShadow&&M.pushShadow(j))}),M.setupLights(),O!==null&&O.updateLights(M.state.lightsArray),rn=this.localClippingEnabled,Ue=st.init(this.clippingPlanes,rn),Ue===!0&&st.setGlobalState(this.clippingPlanes,G),O!==null&&xt.render(M.state.shadowsArray,et,G);let Z=new Set;return E.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let Et=j.material;if(Et)if(Array.isArray(Et))for(let Pt=0;Pt<Et.length;Pt++){let At=Et[Pt];Io(At,et,G,j),Z.add(At)}else Io(Et,et,G,j),Z.add(Et)}),M=b.pop(),O!==null&&O.renderEnd(),Z},this.compileAsync=function(E,G,et=null){let Z=this.compile(E,G,et);return new Promise(j=>{function Et(){if(Z.forEach(function(Pt){let It=Gt.get(Pt).currentProgram;(It===void 0||It.isReady())&&Z.delete(Pt)}),Z.size===0){j(E);return}setTimeout(Et,10)}Jt.get("KHR_parallel_shader_compile")!==null?Et():setTimeout(Et,10)})};let Tr=null;function Eh(E){Tr&&Tr(E)}function Va(){es.stop()}function ki(){es.start()}let es=new u0;es.setAnimationLoop(Eh),typeof self<"u"&&es.setContext(self),this.setAnimationLoop=function(E){Tr=E,dt.setAnimationLoop(E),E===null?es.stop():es.start()},dt.addEventListener("sessionstart",Va),dt.addEventListener("sessionend",ki),this.render=function(E,G){if(G!==void 0&&G.isCamera!==!0){se("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;O!==null&&O.renderStart(E,G);let et=dt.enabled===!0&&dt.isPresenting===!0,Z=N!==null&&(ht===null||et)&&N.begin(R,ht);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),dt.enabled===!0&&dt.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(dt.cameraAutoUpdate===!0&&dt.updateCamera(G),G=dt.getCamera()),E.isScene===!0&&E.onBeforeRender(R,E,G,ht),M=nt.get(E,b.length),M.init(G),M.state.textureUnits=Yt.getTextureUnits(),b.push(M),Fe.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),G.isArrayCamera?Ne.setFromArrayCamera(G):ne.setFromProjectionMatrix(Fe,bi,G.reversedDepth),rn=this.localClippingEnabled,Ue=st.init(this.clippingPlanes,rn),C=St.get(E,_.length),C.init(),_.push(C),this.info.render.frame++,dt.enabled===!0&&dt.isPresenting===!0){let Pt=R.xr.getDepthSensingMesh();Pt!==null&&ns(Pt,G,-1/0,R.sortObjects)}ns(E,G,0,R.sortObjects),C.finish(),O!==null&&O.updateLights(M.state.lightsArray),R.sortObjects===!0&&C.sort(Bt,Kt),Je=dt.enabled===!1||dt.isPresenting===!1||dt.hasDepthSensing()===!1,Je&&F.addToRenderList(C,E),this.info.autoReset===!0&&this.info.reset(),Ue===!0&&st.beginShadows();let j=M.state.shadowsArray;if(xt.render(j,E,G),Ue===!0&&st.endShadows(),(Z&&N.hasRenderPass())===!1){let Pt=C.opaque,At=C.transmissive;if(M.setupLights(),G.isArrayCamera){let It=G.cameras;if(At.length>0)for(let Vt=0,ie=It.length;Vt<ie;Vt++){let pe=It[Vt];Ti(Pt,At,E,pe)}Je&&F.render(E);for(let Vt=0,ie=It.length;Vt<ie;Vt++){let pe=It[Vt];Lo(C,E,pe,pe.viewport)}}else At.length>0&&Ti(Pt,At,E,G),Je&&F.render(E),Lo(C,E,G)}ht!==null&&V===0&&(Yt.updateMultisampleRenderTarget(ht),Yt.updateRenderTargetMipmap(ht)),Z&&N.end(R),E.isScene===!0&&E.onAfterRender(R,E,G),bt.resetDefaultState(),J=-1,k=null,b.pop(),b.length>0?(M=b[b.length-1],Yt.setTextureUnits(M.state.textureUnits),Ue===!0&&st.setGlobalState(R.clippingPlanes,M.state.camera)):M=null,_.pop(),_.length>0?C=_[_.length-1]:C=null,O!==null&&O.renderEnd()};function ns(E,G,et,Z){if(E.visible===!1)return;if(E.layers.test(G.layers)){if(E.isGroup)et=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(G);else if(E.isLight)M.pushLight(E),E.castShadow&&M.pushShadow(E);else if(E.isSprite){let Pt=G.isArrayCamera?Ne:ne;if(!E.frustumCulled||E.intersectsFrustum(Pt)){Z&&Se.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Fe);let At=pt.update(E),It=E.material;It.visible&&C.push(E,At,It,et,Se.z,null,G)}}else if(E.isMesh||E.isLine||E.isPoints){let Pt=G.isArrayCamera?Ne:ne;if(!E.frustumCulled||E.intersectsFrustum(Pt)){let At=pt.update(E),It=E.material;if(Z&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),Se.copy(E.boundingSphere.center)):(At.boundingSphere===null&&At.computeBoundingSphere(),Se.copy(At.boundingSphere.center)),Se.applyMatrix4(E.matrixWorld).applyMatrix4(Fe)),Array.isArray(It)){let Vt=At.groups;for(let ie=0,pe=Vt.length;ie<pe;ie++){let zt=Vt[ie],me=It[zt.materialIndex];me&&me.visible&&C.push(E,At,me,et,Se.z,zt,G)}}else It.visible&&C.push(E,At,It,et,Se.z,null,G)}}}let Et=E.children;for(let Pt=0,At=Et.length;Pt<At;Pt++)ns(Et[Pt],G,et,Z)}function Lo(E,G,et,Z){let{opaque:j,transmissive:Et,transparent:Pt}=E;M.setupLightsView(et),Ue===!0&&st.setGlobalState(R.clippingPlanes,et),Z&&wt.viewport(Q.copy(Z)),j.length>0&&Ke(j,G,et),Et.length>0&&Ke(Et,G,et),Pt.length>0&&Ke(Pt,G,et),wt.buffers.depth.setTest(!0),wt.buffers.depth.setMask(!0),wt.buffers.color.setMask(!0),wt.setPolygonOffset(!1)}function Ti(E,G,et,Z){if((et.isScene===!0?et.overrideMaterial:null)!==null)return;if(M.state.transmissionRenderTarget[Z.id]===void 0){let zt=Jt.has("EXT_color_buffer_half_float")||Jt.has("EXT_color_buffer_float");M.state.transmissionRenderTarget[Z.id]=new mi(1,1,{generateMipmaps:!0,type:zt?Oi:ii,minFilter:ws,samples:Math.max(4,ae.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ye.workingColorSpace})}let Et=M.state.transmissionRenderTarget[Z.id],Pt=Z.viewport||Q;Et.setSize(Pt.z*R.transmissionResolutionScale,Pt.w*R.transmissionResolutionScale);let At=R.getRenderTarget(),It=R.getActiveCubeFace(),Vt=R.getActiveMipmapLevel();R.setRenderTarget(Et),R.getClearColor(K),ut=R.getClearAlpha(),ut<1&&R.setClearColor(16777215,.5),R.clear(),Je&&F.render(et);let ie=R.toneMapping;R.toneMapping=ji;let pe=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),M.setupLightsView(Z),Ue===!0&&st.setGlobalState(R.clippingPlanes,Z),Ke(E,et,Z),Yt.updateMultisampleRenderTarget(Et),Yt.updateRenderTargetMipmap(Et),Jt.has("WEBGL_multisampled_render_to_texture")===!1){let zt=!1;for(let me=0,Ze=G.length;me<Ze;me++){let Ie=G[me],{object:Le,geometry:pn,material:Ut,group:an}=Ie;if(Ut.side===ni&&Le.layers.test(Z.layers)){let xe=Ut.side;Ut.side=ti,Ut.needsUpdate=!0,nn(Le,et,Z,pn,Ut,an),Ut.side=xe,Ut.needsUpdate=!0,zt=!0}}zt===!0&&(Yt.updateMultisampleRenderTarget(Et),Yt.updateRenderTargetMipmap(Et))}R.setRenderTarget(At,It,Vt),R.setClearColor(K,ut),pe!==void 0&&(Z.viewport=pe),R.toneMapping=ie}function Ke(E,G,et){let Z=G.isScene===!0?G.overrideMaterial:null;for(let j=0,Et=E.length;j<Et;j++){let Pt=E[j],{object:At,geometry:It,group:Vt}=Pt,ie=Pt.material;ie.allowOverride===!0&&Z!==null&&(ie=Z),At.layers.test(et.layers)&&nn(At,G,et,It,ie,Vt)}}function nn(E,G,et,Z,j,Et){O!==null&&j.isNodeMaterial&&O.setObject(E,j),E.onBeforeRender(R,G,et,Z,j,Et),E.modelViewMatrix.multiplyMatrices(et.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),j.onBeforeRender(R,G,et,Z,E,Et),j.transparent===!0&&j.side===ni&&j.forceSinglePass===!1?(j.side=ti,j.needsUpdate=!0,R.renderBufferDirect(et,G,Z,j,E,Et),j.side=js,j.needsUpdate=!0,R.renderBufferDirect(et,G,Z,j,E,Et),j.side=ni):R.renderBufferDirect(et,G,Z,j,E,Et),E.onAfterRender(R,G,et,Z,j,Et)}function sn(E){let G=0;for(let et of E)et.texture!==null&&G++;return G}function zi(E,G,et){G.isScene!==!0&&(G=fn);let Z=Gt.get(E),j=M.state.lights,Et=M.state.shadowsArray,Pt=j.state.version,At=at.getParameters(E,j.state,Et,G,et,M.state.lightProbeGridArray),It=at.getProgramCacheKey(At),Vt=Z.programs;Z.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?G.environment:null,Z.fog=G.fog;let ie=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;Z.envMap=I.get(E.envMap||Z.environment,ie),Z.envMapRotation=Z.environment!==null&&E.envMap===null?G.environmentRotation:E.envMapRotation,Vt===void 0&&(E.addEventListener("dispose",he),Vt=new Map,Z.programs=Vt,Z.programVariants=new Map);let pe=Vt.get(It);if(pe!==void 0){if(Z.currentProgram===pe&&Z.lightsStateVersion===Pt)return Do(E,At),pe}else At.uniforms=at.getUniforms(E),O!==null&&E.isNodeMaterial&&O.build(E,et,At),E.onBeforeCompile(At,R),pe=at.acquireProgram(At,It),Vt.set(It,pe),Z.uniforms=At.uniforms;let zt=Z.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(zt.clippingPlanes=st.uniform),Do(E,At),Z.needsLights=Cs(E),Z.lightsStateVersion=Pt,Z.needsLights&&(zt.ambientLightColor.value=j.state.ambient,zt.lightProbe.value=j.state.probe,zt.sunLights.value=j.state.sun,zt.sunLightShadows.value=j.state.sunShadow,zt.directionalLights.value=j.state.directional,zt.directionalLightShadows.value=j.state.directionalShadow,zt.spotLights.value=j.state.spot,zt.spotLightShadows.value=j.state.spotShadow,zt.rectAreaLights.value=j.state.rectArea,zt.ltc_1.value=j.state.rectAreaLTC1,zt.ltc_2.value=j.state.rectAreaLTC2,zt.pointLights.value=j.state.point,zt.pointLightShadows.value=j.state.pointShadow,zt.hemisphereLights.value=j.state.hemi,zt.sunShadowMatrix.value=j.state.sunShadowMatrix,zt.sunShadowCascade.value=j.state.sunShadowCascade,zt.directionalShadowMatrix.value=j.state.directionalShadowMatrix,zt.spotLightMatrix.value=j.state.spotLightMatrix,zt.spotLightMap.value=j.state.spotLightMap,zt.pointShadowMatrix.value=j.state.pointShadowMatrix),Z.numLightProbeGrids=sn(M.state.lightProbeGridArray),Z.currentProgram=pe,Z.uniformsList=null,pe}function ri(E,G,et,Z,j){let Et=Gt.get(E),Pt=Et.currentProgram.id+","+Z+","+j,At=Et.programVariants.get(Pt);return At===void 0?(At=zi(E,G,et),Et.programVariants.set(Pt,At)):(Et.currentProgram=At,Et.uniformsList=null,Et.outputColorSpace=Z,Et.toneMapping=j),At}function Rs(E){if(E.uniformsList===null){let G=E.currentProgram.getUniforms();E.uniformsList=Ro.seqWithValue(G.seq,E.uniforms)}return E.uniformsList}function Do(E,G){let et=Gt.get(E);et.outputColorSpace=G.outputColorSpace,et.batching=G.batching,et.batchingColor=G.batchingColor,et.instancing=G.instancing,et.instancingColor=G.instancingColor,et.instancingMorph=G.instancingMorph,et.skinning=G.skinning,et.morphTargets=G.morphTargets,et.morphNormals=G.morphNormals,et.morphColors=G.morphColors,et.morphTargetsCount=G.morphTargetsCount,et.numClippingPlanes=G.numClippingPlanes,et.numIntersection=G.numClipIntersection,et.vertexAlphas=G.vertexAlphas,et.vertexTangents=G.vertexTangents,et.toneMapping=G.toneMapping}function No(E,G,et,Z,j){G.isScene!==!0&&(G=fn),Yt.resetTextureUnits();let Et=G.fog,Pt=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?G.environment:null,At=ht===null?R.outputColorSpace:ht.isXRRenderTarget===!0?ht.texture.colorSpace:ye.workingColorSpace,It=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,Vt=I.get(Z.envMap||Pt,It),ie=Z.vertexColors===!0&&!!et.attributes.color&&et.attributes.color.itemSize===4,pe=!!et.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),zt=!!et.morphAttributes.position,me=!!et.morphAttributes.normal,Ze=!!et.morphAttributes.color,Ie=ji;Z.toneMapped&&(ht===null||ht.isXRRenderTarget===!0)&&(Ie=R.toneMapping);let Le=et.morphAttributes.position||et.morphAttributes.normal||et.morphAttributes.color,pn=Le!==void 0?Le.length:0,Ut=Gt.get(Z),an=M.state.lights;if(Ue===!0&&(rn===!0||E!==k)){let De=E===k&&Z.id===J;st.setState(Z,E,De)}let xe=!1,is=!1;Z.version===Ut.__version?Ut.needsLights&&Ut.lightsStateVersion!==an.state.version||j.isBatchedMesh&&Ut.batching===!1||!j.isBatchedMesh&&Ut.batching===!0||j.isBatchedMesh&&Ut.batchingColor===!0&&j._colorsTexture===null||j.isBatchedMesh&&Ut.batchingColor===!1&&j._colorsTexture!==null||j.isInstancedMesh&&Ut.instancing===!1||!j.isInstancedMesh&&Ut.instancing===!0||j.isSkinnedMesh&&Ut.skinning===!1||!j.isSkinnedMesh&&Ut.skinning===!0||j.isInstancedMesh&&Ut.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&Ut.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&Ut.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&Ut.instancingMorph===!1&&j.morphTexture!==null||Ut.envMap!==Vt||Z.fog===!0&&Ut.fog!==Et||Ut.numClippingPlanes!==void 0&&(Ut.numClippingPlanes!==st.numPlanes||Ut.numIntersection!==st.numIntersection)||Ut.vertexAlphas!==ie||Ut.vertexTangents!==pe||Ut.morphTargets!==zt||Ut.morphNormals!==me||Ut.morphColors!==Ze||Ut.morphTargetsCount!==pn||Ut.numLightProbeGrids!==sn(M.state.lightProbeGridArray)?xe=!0:(Ut.outputColorSpace!==At||Ut.toneMapping!==Ie)&&(is=!0):(xe=!0,Ut.__version=Z.version);let ln=Ut.currentProgram;(xe===!0||is===!0)&&(ln=is===!0?ri(Z,G,j,At,Ie):zi(Z,G,j),O&&Z.isNodeMaterial&&O.onUpdateProgram(Z,ln,Ut));let Rr=!1,Vi=!1,ss=!1,ue=ln.getUniforms(),je=Ut.uniforms;if(wt.useProgram(ln.program)&&(Rr=!0,Vi=!0,ss=!0),Z.id!==J&&(J=Z.id,Vi=!0),Rr||k!==E){wt.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),ue.setValue(B,"projectionMatrix",E.projectionMatrix),ue.setValue(B,"viewMatrix",E.matrixWorldInverse);let cn=ue.map.cameraPosition;cn!==void 0&&cn.setValue(B,Mn.setFromMatrixPosition(E.matrixWorld)),ae.logarithmicDepthBuffer&&ue.setValue(B,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&ue.setValue(B,"isOrthographic",E.isOrthographicCamera===!0),k!==E&&(k=E,Vi=!0,ss=!0)}if(Ut.needsLights&&(an.state.sunShadowMap.length>0&&ue.setValue(B,"sunShadowMap",an.state.sunShadowMap,Yt),an.state.directionalShadowMap.length>0&&ue.setValue(B,"directionalShadowMap",an.state.directionalShadowMap,Yt),an.state.spotShadowMap.length>0&&ue.setValue(B,"spotShadowMap",an.state.spotShadowMap,Yt),an.state.pointShadowMap.length>0&&ue.setValue(B,"pointShadowMap",an.state.pointShadowMap,Yt)),j.isSkinnedMesh){ue.setOptional(B,j,"bindMatrix"),ue.setOptional(B,j,"bindMatrixInverse");let De=j.skeleton;De&&(De.boneTexture===null&&De.computeBoneTexture(),ue.setValue(B,"boneTexture",De.boneTexture,Yt))}j.isBatchedMesh&&(ue.setOptional(B,j,"batchingTexture"),ue.setValue(B,"batchingTexture",j._matricesTexture,Yt),ue.setOptional(B,j,"batchingIdTexture"),ue.setValue(B,"batchingIdTexture",j._indirectTexture,Yt),ue.setOptional(B,j,"batchingColorTexture"),j._colorsTexture!==null&&ue.setValue(B,"batchingColorTexture",j._colorsTexture,Yt));let Yn=et.morphAttributes;if((Yn.position!==void 0||Yn.normal!==void 0||Yn.color!==void 0)&&rt.update(j,et,ln),(Vi||Ut.receiveShadow!==j.receiveShadow)&&(Ut.receiveShadow=j.receiveShadow,ue.setValue(B,"receiveShadow",j.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&G.environment!==null&&(je.envMapIntensity.value=G.environmentIntensity),je.dfgLUT!==void 0&&(je.dfgLUT.value=N1()),Vi){if(ue.setValue(B,"toneMappingExposure",R.toneMappingExposure),Ut.needsLights&&Er(je,ss),Et&&Z.fog===!0&&yt.refreshFogUniforms(je,Et),yt.refreshMaterialUniforms(je,Z,mt,_t,M.state.transmissionRenderTarget[E.id]),Ut.needsLights&&Ut.numLightProbeGrids>0){let De=S,cn=0;for(let Nn of M.state.lightProbeGridArray)Nn.texture!==null&&(De.textures[cn]=Nn.texture,De.min[cn]=Nn.boundingBox.min,De.max[cn]=Nn.boundingBox.max,De.resolution[cn]=Nn.resolution,cn++);for(let Nn in De)De[Nn].length=cn;je.probesSH.value=De.textures,je.probesMin.value=De.min,je.probesMax.value=De.max,je.probesResolution.value=De.resolution}Ro.upload(B,Rs(Ut),je,Yt)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(Ro.upload(B,Rs(Ut),je,Yt),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&ue.setValue(B,"center",j.center),ue.setValue(B,"modelViewMatrix",j.modelViewMatrix),ue.setValue(B,"normalMatrix",j.normalMatrix),ue.setValue(B,"modelMatrix",j.matrixWorld),Z.uniformsGroups!==void 0){let De=Z.uniformsGroups;for(let cn=0,Nn=De.length;cn<Nn;cn++){let Ga=De[cn];Ht.update(Ga,ln),Ht.bind(Ga,ln)}}return ln}function Er(E,G){E.ambientLightColor.needsUpdate=G,E.lightProbe.needsUpdate=G,E.sunLights.needsUpdate=G,E.sunLightShadows.needsUpdate=G,E.directionalLights.needsUpdate=G,E.directionalLightShadows.needsUpdate=G,E.pointLights.needsUpdate=G,E.pointLightShadows.needsUpdate=G,E.spotLights.needsUpdate=G,E.spotLightShadows.needsUpdate=G,E.rectAreaLights.needsUpdate=G,E.hemisphereLights.needsUpdate=G}function Cs(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return W},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return ht},this.setRenderTargetTextures=function(E,G,et){let Z=Gt.get(E);Z.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),Gt.get(E.texture).__webglTexture=G,Gt.get(E.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:et,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,G){let et=Gt.get(E);et.__webglFramebuffer=G,et.__useDefaultFramebuffer=G===void 0},this.setRenderTarget=function(E,G=0,et=0){ht=E,W=G,V=et;let Z=null,j=!1,Et=!1;if(E){let At=Gt.get(E);if(At.__useDefaultFramebuffer!==void 0){wt.bindFramebuffer(B.FRAMEBUFFER,At.__webglFramebuffer),Q.copy(E.viewport),lt.copy(E.scissor),ot=E.scissorTest,wt.viewport(Q),wt.scissor(lt),wt.setScissorTest(ot),J=-1;return}else if(At.__webglFramebuffer===void 0)Yt.setupRenderTarget(E);else if(At.__hasExternalTextures)Yt.rebindTextures(E,Gt.get(E.texture).__webglTexture,Gt.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let ie=E.depthTexture;if(At.__boundDepthTexture!==ie){if(ie!==null&&Gt.has(ie)&&(E.width!==ie.image.width||E.height!==ie.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Yt.setupDepthRenderbuffer(E)}}let It=E.texture;(It.isData3DTexture||It.isDataArrayTexture||It.isCompressedArrayTexture)&&(Et=!0);let Vt=Gt.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Vt[G])?Z=Vt[G][et]:Z=Vt[G],j=!0):E.samples>0&&Yt.useMultisampledRTT(E)===!1?Z=Gt.get(E).__webglMultisampledFramebuffer:Array.isArray(Vt)?Z=Vt[et]:Z=Vt,Q.copy(E.viewport),lt.copy(E.scissor),ot=E.scissorTest}else Q.copy(Ft).multiplyScalar(mt).floor(),lt.copy(ce).multiplyScalar(mt).floor(),ot=le;if(et!==0&&(Z=z),wt.bindFramebuffer(B.FRAMEBUFFER,Z)&&wt.drawBuffers(E,Z),wt.viewport(Q),wt.scissor(lt),wt.setScissorTest(ot),j){let At=Gt.get(E.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+G,At.__webglTexture,et)}else if(Et){let At=G;for(let It=0;It<E.textures.length;It++){let Vt=Gt.get(E.textures[It]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+It,Vt.__webglTexture,et,At)}}else if(E!==null&&et!==0){let At=Gt.get(E.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,At.__webglTexture,et)}J=-1};function Ar(E){let G=Gt.get(E);return(G.__readFormat!==E.format||G.__readType!==E.type)&&(G.__readFormat=E.format,G.__readType=E.type,G.__formatReadable=ae.textureFormatReadable(E.format),G.__typeReadable=ae.textureTypeReadable(E.type)),G}this.readRenderTargetPixels=function(E,G,et,Z,j,Et,Pt,At=0){if(!(E&&E.isWebGLRenderTarget)){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let It=Gt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It){wt.bindFramebuffer(B.FRAMEBUFFER,It);try{let Vt=E.textures[At],ie=Vt.format,pe=Vt.type;E.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+At);let zt=Ar(Vt);if(zt.__formatReadable===!1){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(zt.__typeReadable===!1){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=E.width-Z&&et>=0&&et<=E.height-j&&B.readPixels(G,et,Z,j,vt.convert(ie),vt.convert(pe),Et)}finally{let Vt=ht!==null?Gt.get(ht).__webglFramebuffer:null;wt.bindFramebuffer(B.FRAMEBUFFER,Vt)}}},this.readRenderTargetPixelsAsync=async function(E,G,et,Z,j,Et,Pt,At=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let It=Gt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It)if(G>=0&&G<=E.width-Z&&et>=0&&et<=E.height-j){wt.bindFramebuffer(B.FRAMEBUFFER,It);let Vt=E.textures[At],ie=Vt.format,pe=Vt.type;E.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+At);let zt=Ar(Vt);if(zt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(zt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let me=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,me),B.bufferData(B.PIXEL_PACK_BUFFER,Et.byteLength,B.STREAM_READ),B.readPixels(G,et,Z,j,vt.convert(ie),vt.convert(pe),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let Ze=ht!==null?Gt.get(ht).__webglFramebuffer:null;wt.bindFramebuffer(B.FRAMEBUFFER,Ze);let Ie=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await Fg(B,Ie,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,me),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Et),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(me),B.deleteSync(Ie),Et}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,G=null,et=0){let Z=Math.pow(2,-et),j=Math.floor(E.image.width*Z),Et=Math.floor(E.image.height*Z),Pt=G!==null?G.x:0,At=G!==null?G.y:0;Yt.setTexture2D(E,0),B.copyTexSubImage2D(B.TEXTURE_2D,et,0,0,Pt,At,j,Et),wt.unbindTexture()},this.copyTextureToTexture=function(E,G,et=null,Z=null,j=0,Et=0){let Pt,At,It,Vt,ie,pe,zt,me,Ze,Ie=E.isCompressedTexture?E.mipmaps[Et]:E.image;if(et!==null)Pt=et.max.x-et.min.x,At=et.max.y-et.min.y,It=et.isBox3?et.max.z-et.min.z:1,Vt=et.min.x,ie=et.min.y,pe=et.isBox3?et.min.z:0;else{let ue=Math.pow(2,-j);Pt=Math.floor(Ie.width*ue),At=Math.floor(Ie.height*ue),E.isDataArrayTexture?It=Ie.depth:E.isData3DTexture?It=Math.floor(Ie.depth*ue):It=1,Vt=0,ie=0,pe=0}Z!==null?(zt=Z.x,me=Z.y,Ze=Z.z):(zt=0,me=0,Ze=0);let Le=vt.convert(G.format),pn=vt.convert(G.type),Ut;G.isData3DTexture?(Yt.setTexture3D(G,0),Ut=B.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(Yt.setTexture2DArray(G,0),Ut=B.TEXTURE_2D_ARRAY):(Yt.setTexture2D(G,0),Ut=B.TEXTURE_2D),wt.activeTexture(B.TEXTURE0),wt.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,G.flipY),wt.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),wt.pixelStorei(B.UNPACK_ALIGNMENT,G.unpackAlignment);let an=wt.getParameter(B.UNPACK_ROW_LENGTH),xe=wt.getParameter(B.UNPACK_IMAGE_HEIGHT),is=wt.getParameter(B.UNPACK_SKIP_PIXELS),ln=wt.getParameter(B.UNPACK_SKIP_ROWS),Rr=wt.getParameter(B.UNPACK_SKIP_IMAGES);wt.pixelStorei(B.UNPACK_ROW_LENGTH,Ie.width),wt.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Ie.height),wt.pixelStorei(B.UNPACK_SKIP_PIXELS,Vt),wt.pixelStorei(B.UNPACK_SKIP_ROWS,ie),wt.pixelStorei(B.UNPACK_SKIP_IMAGES,pe);let Vi=E.isDataArrayTexture||E.isData3DTexture,ss=G.isDataArrayTexture||G.isData3DTexture;if(E.isDepthTexture){let ue=Gt.get(E),je=Gt.get(G),Yn=Gt.get(ue.__renderTarget),De=Gt.get(je.__renderTarget);wt.bindFramebuffer(B.READ_FRAMEBUFFER,Yn.__webglFramebuffer),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,De.__webglFramebuffer);for(let cn=0;cn<It;cn++)Vi&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Gt.get(E).__webglTexture,j,pe+cn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Gt.get(G).__webglTexture,Et,Ze+cn)),B.blitFramebuffer(Vt,ie,Vt+Pt,ie+At,zt,me,zt+Pt,me+At,B.DEPTH_BUFFER_BIT,B.NEAREST);wt.bindFramebuffer(B.READ_FRAMEBUFFER,null),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(j!==0||E.isRenderTargetTexture||Gt.has(E)){let ue=Gt.get(E),je=Gt.get(G);wt.bindFramebuffer(B.READ_FRAMEBUFFER,D),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,H);for(let Yn=0;Yn<It;Yn++)Vi?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ue.__webglTexture,j,pe+Yn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ue.__webglTexture,j),ss?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,je.__webglTexture,Et,Ze+Yn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,je.__webglTexture,Et),j!==0?B.blitFramebuffer(Vt,ie,Vt+Pt,ie+At,zt,me,zt+Pt,me+At,B.COLOR_BUFFER_BIT,B.NEAREST):ss?B.copyTexSubImage3D(Ut,Et,zt,me,Ze+Yn,Vt,ie,Pt,At):B.copyTexSubImage2D(Ut,Et,zt,me,Vt,ie,Pt,At);wt.bindFramebuffer(B.READ_FRAMEBUFFER,null),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else ss?E.isDataTexture||E.isData3DTexture?B.texSubImage3D(Ut,Et,zt,me,Ze,Pt,At,It,Le,pn,Ie.data):G.isCompressedArrayTexture?B.compressedTexSubImage3D(Ut,Et,zt,me,Ze,Pt,At,It,Le,Ie.data):B.texSubImage3D(Ut,Et,zt,me,Ze,Pt,At,It,Le,pn,Ie):E.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Et,zt,me,Pt,At,Le,pn,Ie.data):E.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Et,zt,me,Ie.width,Ie.height,Le,Ie.data):B.texSubImage2D(B.TEXTURE_2D,Et,zt,me,Pt,At,Le,pn,Ie);wt.pixelStorei(B.UNPACK_ROW_LENGTH,an),wt.pixelStorei(B.UNPACK_IMAGE_HEIGHT,xe),wt.pixelStorei(B.UNPACK_SKIP_PIXELS,is),wt.pixelStorei(B.UNPACK_SKIP_ROWS,ln),wt.pixelStorei(B.UNPACK_SKIP_IMAGES,Rr),Et===0&&G.generateMipmaps===!0&&G.mipmapsAutoUpdate===!0&&B.generateMipmap(Ut),wt.unbindTexture()},this.initRenderTarget=function(E){Gt.get(E).__webglFramebuffer===void 0&&Yt.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Yt.setTextureCube(E,0):E.isData3DTexture?Yt.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Yt.setTexture2DArray(E,0):Yt.setTexture2D(E,0),wt.unbindTexture()},this.resetState=function(){W=0,V=0,ht=null,wt.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return bi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=ye._getDrawingBufferColorSpace(t),e.unpackColorSpace=ye._getUnpackColorSpace()}};var M0={type:"change"},Xd={type:"start"},w0={type:"end"},vh=new mr,b0=new pi,U1=Math.cos(70*dh.DEG2RAD),Sn=new q,si=2*Math.PI,Re={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Wd=1e-6,yh=class extends Ra{constructor(t,e=null){super(t,e),this.state=Re.NONE,this.target=new q,this.cursor=new q,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Js.ROTATE,MIDDLE:Js.DOLLY,RIGHT:Js.PAN},this.touches={ONE:Ks.ROTATE,TWO:Ks.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new q,this._lastQuaternion=new Qn,this._lastTargetPosition=new q,this._quat=new Qn().setFromUnitVectors(t.up,new q(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Mo,this._sphericalDelta=new Mo,this._scale=1,this._panOffset=new q,this._rotateStart=new ee,this._rotateEnd=new ee,this._rotateDelta=new ee,this._panStart=new ee,this._panEnd=new ee,this._panDelta=new ee,this._dollyStart=new ee,this._dollyEnd=new ee,this._dollyDelta=new ee,this._dollyDirection=new q,this._mouse=new ee,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=O1.bind(this),this._onPointerDown=F1.bind(this),this._onPointerUp=B1.bind(this),this._onContextMenu=X1.bind(this),this._onMouseWheel=V1.bind(this),this._onKeyDown=G1.bind(this),this._onTouchStart=H1.bind(this),this._onTouchMove=W1.bind(this),this._onMouseDown=k1.bind(this),this._onMouseMove=z1.bind(this),this._interceptControlDown=q1.bind(this),this._interceptControlUp=Y1.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Re.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(M0),this.update(),this.state=Re.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Sn.copy(e).sub(this.target),Sn.applyQuaternion(this._quat),this._spherical.setFromVector3(Sn),this.autoRotate&&this.state===Re.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=si:n>Math.PI&&(n-=si),s<-Math.PI?s+=si:s>Math.PI&&(s-=si),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Sn.setFromSpherical(this._spherical),Sn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Sn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Sn.length();o=this._clampDistance(a*this._scale);let c=a-o;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),r=!!c}else if(this.object.isOrthographicCamera){let a=new q(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=c!==this.object.zoom;let l=new q(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(a),this.object.updateMatrixWorld(),o=Sn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(vh.origin.copy(this.object.position),vh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(vh.direction))<U1?this.object.lookAt(this.target):(b0.setFromNormalAndCoplanarPoint(this.object.up,this.target),vh.intersectPlane(b0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Wd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Wd||this._lastTargetPosition.distanceToSquared(this.target)>Wd?(this.dispatchEvent(M0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?si/60*this.autoRotateSpeed*t:si/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Sn.setFromMatrixColumn(e,0),Sn.multiplyScalar(-t),this._panOffset.add(Sn)}_panUp(t,e){this.screenSpacePanning===!0?Sn.setFromMatrixColumn(e,1):(Sn.setFromMatrixColumn(e,0),Sn.crossVectors(this.object.up,Sn)),Sn.multiplyScalar(t),this._panOffset.add(Sn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Sn.copy(s).sub(this.target);let r=Sn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(si*this._rotateDelta.x/e.clientHeight),this._rotateUp(si*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(si*this._rotateDelta.x/e.clientHeight),this._rotateUp(si*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new ee,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function F1(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function O1(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function B1(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(w0),this.state=Re.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function k1(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Js.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Re.DOLLY;break;case Js.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Re.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Re.ROTATE}break;case Js.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Re.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Re.PAN}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(Xd)}function z1(i){switch(this.state){case Re.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Re.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Re.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function V1(i){this.enabled===!1||this.enableZoom===!1||this.state!==Re.NONE||(i.preventDefault(),this.dispatchEvent(Xd),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(w0))}function G1(i){this.enabled!==!1&&this._handleKeyDown(i)}function H1(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Ks.ROTATE:if(this.enableRotate===!1){this.state=Re.NONE;break}this._handleTouchStartRotate(i),this.state=Re.TOUCH_ROTATE;break;case Ks.PAN:if(this.enablePan===!1){this.state=Re.NONE;break}this._handleTouchStartPan(i),this.state=Re.TOUCH_PAN;break;default:this.state=Re.NONE}break;case 2:switch(this.touches.TWO){case Ks.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Re.TOUCH_DOLLY_PAN;break;case Ks.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Re.TOUCH_DOLLY_ROTATE;break;default:this.state=Re.NONE}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(Xd)}function W1(i){switch(this._trackPointer(i),this.state){case Re.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Re.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Re.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Re.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Re.NONE}}function X1(i){this.enabled!==!1&&i.preventDefault()}function q1(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Y1(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function E0(i,t=!1){let e=i[0].index!==null,n=new Set(Object.keys(i[0].attributes)),s=new Set(Object.keys(i[0].morphAttributes)),r={},o={},a=i[0].morphTargetsRelative,c=new Dn;c.morphTargetsRelative=a;let l=0;for(let h=0;h<i.length;++h){let d=i[h],u=0,f=0;if(e!==(d.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in d.attributes){if(!n.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(d.attributes[p]),u++}if(u!==n.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of attributes."),null;if(a!==d.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in d.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+".  .morphAttributes must be consistent throughout all geometries."),null;if(d.morphAttributes[p].length!==i[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(d.morphAttributes[p]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of morph attributes."),null;if(t){let p;if(e)p=d.index.count;else if(d.attributes.position!==void 0)p=d.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". The geometry must have either an index or a position attribute"),null;c.addGroup(l,p,h),l+=p}}if(e){let h=0,d=[];for(let u=0;u<i.length;++u){let f=i[u].index;for(let p=0;p<f.count;++p)d.push(f.getX(p)+h);h+=i[u].attributes.position.count}c.setIndex(d)}for(let h in r){let d=T0(r[h]);if(!d)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" attribute."),null;c.setAttribute(h,d)}for(let h in o){let d=o[h][0].length;if(d!==0){c.morphAttributes=c.morphAttributes||{},c.morphAttributes[h]=[];for(let u=0;u<d;++u){let f=[];for(let y=0;y<o[h].length;++y)f.push(o[h][y][u]);let p=T0(f);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" morphAttribute."),null;c.morphAttributes[h].push(p)}}}return c}function T0(i){let t,e,n,s=-1,r=0;for(let l=0;l<i.length;++l){let h=i[l];if(t===void 0&&(t=h.array.constructor),t!==h.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=h.itemSize),e!==h.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(n===void 0&&(n=h.normalized),n!==h.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=h.gpuType),s!==h.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=h.count*e}let o=new t(r),a=new Vn(o,e,n),c=0;for(let l=0;l<i.length;++l){let h=i[l];if(h.isInterleavedBufferAttribute){let d=c/e;for(let u=0,f=h.count;u<f;u++)for(let p=0;p<e;p++){let y=h.getComponent(u,p);a.setComponent(u+d,p,y)}}else o.set(h.array,c);c+=h.count*e}return s!==void 0&&(a.gpuType=s),a}var qd=new q(0,1,0),Sh=Math.PI/24,$1=new q(.7,.5,1.22).normalize(),Z1=1.08;function J1(){let i=new yo(.035,.035,.7,6).translate(0,-.15,0),t=new ya(.11,.3,8).translate(0,.35,0),e=E0([i,t]);return i.dispose(),t.dispose(),e}var Mh=class{constructor(){this.canvas=Y("canvas",{class:"space",tabindex:"0",role:"img","aria-label":"Velocity vectors in space; arrow keys turn them, plus and minus zoom"}),this.labels=["x","y","z"].map(e=>Y("span",{class:"axis-label","aria-hidden":"true"},e)),this.element=Y("div",{class:"space-frame"},this.canvas,...this.labels),this.renderer=new gh({canvas:this.canvas,antialias:!0,alpha:!0}),this.scene=new da,this.camera=new jn(35,1,.1,1e3),this.camera.up.set(0,1,0),this.controls=new yh(this.camera,this.canvas),this.controls.enableDamping=!1,this.controls.addEventListener("change",()=>this.draw()),this.canvas.addEventListener("keydown",e=>this.key(e)),new ResizeObserver(()=>this.draw()).observe(this.canvas),this.scene.add(new Aa(16777215,1.6));let t=new Ea(16777215,2.2);this.camera.add(t),t.position.set(1,2,3),this.scene.add(this.camera),this.group=new _s,this.scene.add(this.group),this.box=new ga(new Dn,new vo),this.group.add(this.box),this.vectorMaterial=new xr,this.arrow=J1(),this.vectors=null,this.surface=new Hn(new Dn,new xr({side:ni,transparent:!0,opacity:.6,depthWrite:!1})),this.surface.visible=!1,this.group.add(this.surface),this.bodies=new Hn(new Dn,new xr({side:ni,transparent:!0,opacity:.45,depthWrite:!1})),this.bodies.visible=!1,this.drawnMask=null,this.group.add(this.bodies),this.slice=new Hn(new _r(1,1),new _o({side:ni,transparent:!0,opacity:.7})),this.slice.visible=!1,this.group.add(this.slice),this.size=null,this.isFramed=!1}key(t){let e={ArrowLeft:[-Sh,0],ArrowRight:[Sh,0],ArrowUp:[0,-Sh],ArrowDown:[0,Sh]},n={"+":.9,"=":.9,"-":1/.9};if(e[t.key])this.turn(...e[t.key]);else if(n[t.key])this.camera.position.multiplyScalar(n[t.key]);else return;t.preventDefault(),this.controls.update(),this.draw()}turn(t,e){let{position:n}=this.camera;n.applyAxisAngle(qd,t);let s=new q().crossVectors(qd,n).normalize(),r=n.clone().applyAxisAngle(s,e);Math.abs(r.clone().normalize().y)<.99&&n.copy(r),this.camera.lookAt(0,0,0)}frame(t){let e=t.n.map(s=>s*t.spacing);if(this.size&&e.every((s,r)=>s===this.size[r]))return;this.size=e,this.box.geometry.dispose();let n=new qs(...e);this.box.geometry=new Sa(n),n.dispose(),this.isFramed=!1}standBack(){let t=this.camera.fov/2*(Math.PI/180),e=Math.min(t,Math.atan(Math.tan(t)*this.camera.aspect)),n=Math.hypot(...this.size)/2;this.camera.position.copy($1).multiplyScalar(Z1*n/Math.sin(e)),this.isFramed=!0,this.controls.target.set(0,0,0),this.controls.update()}place(t,e,n,s){return new q(...[e,n,s].map((r,o)=>(r-(t.n[o]-1)/2)*t.spacing))}showVectors(t,e,n,s){let r=t.status.length;(!this.vectors||this.vectors.instanceMatrix.count<r)&&(this.vectors&&(this.group.remove(this.vectors),this.vectors.dispose()),this.vectors=new ma(this.arrow,this.vectorMaterial,r),this.vectors.instanceMatrix.setUsage(uh),this.vectors.frustumCulled=!1,this.group.add(this.vectors)),this.vectors.visible=s;let[o,a,c,l,h]=[new q,new Ae,new Qn,new q,new fe],d=1.3*t.spacing,u=0;for(let f=0;f<r;f+=1){o.set(e[3*f],e[3*f+1],e[3*f+2]);let p=o.length();if(!(p>0))continue;let[y,m]=[f%t.n[0],Math.floor(f/t.n[0])%t.n[1]],g=Math.floor(f/(t.n[0]*t.n[1]));c.setFromUnitVectors(qd,o.divideScalar(p));let v=d*Math.min(1.2,Math.max(.15,p/n.high));l.set(.75*d,v,.75*d),this.vectors.setMatrixAt(u,a.compose(this.place(t,y,m,g),c,l));let[A,S,C]=n.rgb(p);this.vectors.setColorAt(u,h.setRGB(A/255,S/255,C/255,zn)),u+=1}this.vectors.count=u,this.vectors.instanceMatrix.needsUpdate=!0,this.vectors.instanceColor&&(this.vectors.instanceColor.needsUpdate=!0)}showBodies(t,e){if(this.bodies.visible=!!e,!e||this.drawnMask===e&&this.maskedSize===this.size)return;[this.drawnMask,this.maskedSize]=[e,this.size];let n=t.first.map((a,c)=>a+(t.n[c]-1)/2*t.spacing),s=a=>n.map((c,l)=>c+a*this.size[l]/2),r=bf(e,s(-1),s(1)).map((a,c)=>a-n[c%3]),{geometry:o}=this.bodies;o.dispose(),o.setAttribute("position",new Vn(r,3)),o.deleteAttribute("normal"),o.computeVertexNormals(),this.bodies.visible=r.length>0}showSurface(t,e){if(this.surface.visible=!!e?.length,!this.surface.visible)return;let{geometry:n}=this.surface,s=n.getAttribute("position");(!s||s.array.length<e.length)&&(n.dispose(),n.setAttribute("position",new Vn(new Float32Array(2*e.length),3).setUsage(uh)),n.deleteAttribute("normal"));let r=n.getAttribute("position");e.forEach((o,a)=>{let c=a%3;r.array[a]=(o-(t.n[c]-1)/2)*t.spacing}),r.needsUpdate=!0,n.setDrawRange(0,e.length/3),n.computeVertexNormals()}showSlice(t,e,n,s,r,o){if(this.slice.visible=!!s,!s)return;let{material:a}=this.slice;(!a.map||a.map.image.width!==r||a.map.image.height!==o)&&(a.map?.dispose(),a.map=new gr(new Uint8Array(4*r*o),r,o,_i),a.map.colorSpace=zn,a.map.magFilter=Ln,a.needsUpdate=!0),a.map.image.data.set(s),a.map.needsUpdate=!0;let{n:c,spacing:l}=t,h=this.place(t,...c.map((y,m)=>m===e?n:(y-1)/2)),[d,u]=[[1,2],[0,2],[0,1]][e],f=y=>new q(...[0,1,2].map(m=>y===m?1:0)),p=new q().crossVectors(f(d),f(u));this.slice.setRotationFromMatrix(new Ae().makeBasis(f(d),f(u),p)),this.slice.position.copy(h),this.slice.scale.set(c[d]*l,c[u]*l,1)}draw(){if(this.canvas.clientWidth===0||!this.size)return;let{width:t,height:e,ratio:n}=Us(this.canvas);this.renderer.setPixelRatio(1),this.renderer.setSize(t,e,!1),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.isFramed||this.standBack(),this.box.material.color.set(Fn("faint-ink")),this.surface.material.color.set(Fn("surface")),this.bodies.material.color.set(Fn("mask")),this.renderer.render(this.scene,this.camera),this.placeLabels(t/n,e/n);let{geometries:s,textures:r}=this.renderer.info.memory;this.canvas.dataset.gpuObjects=String(s+r)}placeLabels(t,e){let[n,s,r]=this.size.map(a=>a/2);[new q(0,-s,r),new q(-n,0,r),new q(n,-s,0)].forEach((a,c)=>{let l=this.labels[c];l.textContent=`${"xyz"[c]}  ${qt(this.size[c])} mm`;let h=a.multiplyScalar(1.12).project(this.camera);l.style.left=`${(h.x+1)/2*t}px`,l.style.top=`${(1-h.y)/2*e}px`})}};var As=[[1,2],[0,2],[0,1]];function bh(i,t,e,n){let[s,r]=As[e],o=[];for(let a=0;a<i.n[r];a+=1){let c=[];for(let l=0;l<i.n[s];l+=1){let h=[0,0,0];[h[e],h[s],h[r]]=[n,l,a],c.push(t[Ja(i,...h)])}o.push(c)}return o}function Yd(i,t){let e=i[0].length,n=new Uint8Array(4*e*i.length);return i.flat().forEach((s,r)=>{s===s&&n.set([...t.rgb(s),255],4*r)}),n}var j1=.5,wh=class{constructor(t){this.canvas=Y("canvas",{class:"slice",role:"img","aria-label":"Slice through the field"}),this.buffer=document.createElement("canvas"),this.canvas.addEventListener("pointerdown",e=>{if(!this.area)return;let n=this.canvas.getBoundingClientRect(),[s,r,o,a]=this.area,c=(e.clientX-n.left-s)/o,l=1-(e.clientY-n.top-r)/a;c>=0&&c<=1&&l>=0&&l<=1&&t(c,l)})}draw(t,e,n,{axis:s,index:r,scale:o,longest:a,line:c}){let{width:l,height:h,ratio:d}=Us(this.canvas),u=this.canvas.getContext("2d");if(u.setTransform(1,0,0,1,0,0),u.clearRect(0,0,l,h),l<20)return;let[f,p]=As[s],[y,m]=[t.n[f],t.n[p]],[g,v]=[44*d,34*d],A=Math.min((l-g-8*d)/y,(h-v-8*d)/m),[S,C]=[A*y,A*m],[M,_]=[g+(l-g-8*d-S)/2,8*d+(h-v-8*d-C)/2];this.area=[M,_,S,C].map(N=>N/d),this.contour(u,bh(t,e,s,r),o,[M,_,S,C]),this.body(u,bh(t,t.status,s,r),[M,_+C,A]);let b=Fn("ink");if(u.strokeStyle=b,u.lineWidth=d,u.strokeRect(M,_,S,C),this.arrows(u,t,n,{axis:s,index:r,cell:A,x0:M,y0:_+C,longest:a,ratio:d}),c){let N=(c.index+.5)*A;u.setLineDash([6*d,4*d]),u.lineWidth=2*d,u.strokeStyle=b,u.beginPath(),c.along===0?(u.moveTo(M,_+C-N),u.lineTo(M+S,_+C-N)):(u.moveTo(M+N,_),u.lineTo(M+N,_+C)),u.stroke(),u.setLineDash([])}this.axes(u,t,{axis:s,ratio:d,x0:M,y0:_,w:S,hgt:C,ink:b})}contour(t,e,n,[s,r,o,a]){let c=e[0].length;[this.buffer.width,this.buffer.height]=[c,e.length];let l=Yd([...e].reverse(),n),h=new ImageData(new Uint8ClampedArray(l),c,e.length);this.buffer.getContext("2d").putImageData(h,0,0),t.imageSmoothingEnabled=!1,t.drawImage(this.buffer,s,r,o,a)}body(t,e,[n,s,r]){t.globalAlpha=j1,t.fillStyle=Fn("mask"),e.forEach((o,a)=>o.forEach((c,l)=>{c===3&&t.fillRect(n+l*r,s-(a+1)*r,r,r)})),t.globalAlpha=1}arrows(t,e,n,{axis:s,index:r,cell:o,x0:a,y0:c,longest:l,ratio:h}){let[d,u]=As[s];t.lineCap="round";for(let[f,p]of[["#ffffffc0",3.2],["#101418",1.5]]){t.strokeStyle=f,t.lineWidth=p*h*Math.min(1,o/(14*h)),t.beginPath();for(let y=0;y<e.n[u];y+=1)for(let m=0;m<e.n[d];m+=1){let g=[0,0,0];[g[s],g[d],g[u]]=[r,m,y];let v=Ja(e,...g),[A,S]=[n[3*v+d],n[3*v+u]];if(A!==A||Math.hypot(A,S)<.02*l)continue;let C=.95*o/l,[M,_]=[a+(m+.5)*o,c-(y+.5)*o],[b,N]=[A*C,-S*C],[R,P]=[M+b/2,_+N/2];t.moveTo(M-b/2,_-N/2),t.lineTo(R,P);let[O,z]=[.3,.17];t.moveTo(R-O*b-z*N,P-O*N+z*b),t.lineTo(R,P),t.lineTo(R-O*b+z*N,P-O*N-z*b)}t.stroke()}}axes(t,e,{axis:n,ratio:s,x0:r,y0:o,w:a,hgt:c,ink:l}){let[h,d]=As[n];t.fillStyle=l,t.font=`${12*s}px system-ui, sans-serif`;let u=g=>[e.first[g]-e.spacing/2,e.first[g]+(e.n[g]-.5)*e.spacing],[f,p]=u(h),[y,m]=u(d);t.textBaseline="top",t.textAlign="left",t.fillText(On(f),r,o+c+6*s),t.textAlign="right",t.fillText(On(p),r+a,o+c+6*s),t.textAlign="center",t.fillText(`${"xyz"[h]} (mm)`,r+a/2,o+c+6*s),t.textAlign="right",t.textBaseline="bottom",t.fillText(On(y),r-6*s,o+c),t.textBaseline="top",t.fillText(On(m),r-6*s,o),t.textBaseline="middle",t.fillText(`${"xyz"[d]}`,r-6*s,o+c/2)}};var Q1=[[0,1,3,7],[0,3,2,7],[0,2,6,7],[0,6,4,7],[0,4,5,7],[0,5,1,7]];function A0(i,t,e){let n=[],s=(r,o)=>r+(o&1)+t[0]*(o>>1&1)+t[0]*t[1]*(o>>2&1);for(let r=0;r+1<t[2];r+=1)for(let o=0;o+1<t[1];o+=1)for(let a=0;a+1<t[0];a+=1){let c=a+t[0]*(o+t[1]*r),l=Array.from({length:8},(h,d)=>i[s(c,d)]);if(!l.some(h=>h!==h))for(let h of Q1)tT(h,l,[a,o,r],e,n)}return new Float32Array(n)}function tT(i,t,e,n,s){let r=i.filter(h=>t[h]>=n),o=i.filter(h=>t[h]<n);if(r.length===0||o.length===0)return;let a=(h,d)=>{let u=(n-t[h])/(t[d]-t[h]);return[0,1,2].map(f=>{let[p,y]=[h>>f&1,d>>f&1];return e[f]+p+u*(y-p)})};if(r.length===2){let[h,d]=r,[u,f]=o,[p,y,m,g]=[a(h,u),a(h,f),a(d,f),a(d,u)];s.push(...p,...y,...m,...p,...m,...g);return}let[c,l]=r.length===1?[r[0],o]:[o[0],r];for(let h of l)s.push(...a(c,h))}var eT={shot:"this shot",mean:"mean over shots",rms:"rms over shots"},$d={speed:"speed",u:"u along x",v:"v along y",w:"w along z",vorticity:"|vorticity|",vorticity_x:"vorticity about x",vorticity_y:"vorticity about y",vorticity_z:"vorticity about z",uncertainty:"standard uncertainty"},R0={0:"x",1:"y",2:"z"},Zd=.99;function C0(i,t){let e={shown:"shot",quantity:"speed",axis:2,index:null,along:0,line:null,level:60},n=new Mh,s=Jo(),r=Jo(),o=new wh((k,Q)=>R(k,Q)),a=Yr(i,k=>t.hold(k)),c=Y("p",{class:"empty"}),l={valid:Wt("Valid vectors"),replaced:Wt("Replaced"),masked:Wt("Masked",{title:"vectors whose place is not flow, as [volume.mask] says; no share counts them"}),speed:Wt("Largest speed",{title:"99th percentile"}),uncertainty:Wt("Uncertainty",{title:"median standard uncertainty of a component"}),shots:Wt("Shots in mean and rms")},h=Ns("Vectors",!0,()=>N()),d=Ns("Vorticity surface",!0,()=>N()),u=Ns("Slice",!0,()=>N()),f=zo("Surface at",{max:95,value:e.level},k=>N({level:k})),p=as("Show",eT,k=>N({shown:k})),y=as("Colour of the slice",$d,k=>N({quantity:k})),m=as("Slice across",R0,k=>N({axis:Number(k),index:null,line:null}));m.input.value="2";let g=zo("at",{max:1},k=>N({index:k})),v=as("Profile along",R0,k=>N({along:Number(k),line:null})),A=new Ii({x:"position (mm)",y:"velocity (m/s)",alt:"Velocity along the dashed line of the slice",series:[{label:"u"},{label:"v"},{label:"w"}]}),S=[0,1,2].map(k=>new Ii({x:`displacement along ${"xyz"[k]} (voxel)`,y:"vectors",height:130,alt:`Histogram of the displacements along ${"xyz"[k]}`,series:[{label:"vectors",kind:"bars"}]})),C=Y("p",{class:"hint legend"},Y("span",{class:"swatch","aria-hidden":"true"}),"Not flow");C.hidden=!0;let M=Y("p",{class:"advice"}),_=Y("p",{class:"advice"}),b=Y("div",{class:"view velocity"},Y("div",{class:"controls"},a.element,p.element,c),Y("dl",{class:"readings"},...Object.values(l).map(k=>k.element)),Y("div",{class:"two"},en("In space",n.element,s.element,Y("div",{class:"controls"},h.element,d.element,f.element,u.element)),en("Slice",Y("div",{class:"controls"},m.element,g.element,y.element),o.canvas,r.element,C)),Y("div",{class:"two"},en("Profile",Y("div",{class:"controls"},v.element,Y("p",{class:"hint"},"Press a place in the slice to move the line.")),A.element),en("Displacements",...S.map(k=>k.element),M,_)));t.watch(()=>N());function N(k={}){Object.assign(e,k),b.isConnected&&!b.hidden&&z()}function R(k,Q){let{field:lt}=t;if(!lt)return;let[ot,K]=As[e.axis],ut=e.along===K,[ft,_t]=ut?[k,lt.n[ot]]:[Q,lt.n[K]];e.along===e.axis&&(e.along=ot),v.input.value=String(e.along),N({line:Math.min(_t-1,Math.floor(ft*_t))})}function P(k){return e.shown==="shot"||t.running.shots===0?k.u:e.shown==="mean"?t.running.mean():t.running.rms()}function O(k,Q,lt){let ot=e.quantity;if(ot==="speed")return[Fr(Q),"speed (m/s)",!1];if(ot==="uncertainty")return[Fr(k.uncertainty).map(ut=>ut/Math.sqrt(3)),"standard uncertainty of a component (m/s)",!1];if(ot==="vorticity")return[Fr(lt),"|vorticity| (1/s)",!1];let K={u:0,v:1,w:2,vorticity_x:0,vorticity_y:1,vorticity_z:2}[ot];return ot.startsWith("vorticity")?[Hh(lt,K),`${$d[ot]} (1/s)`,!0]:[Hh(Q,K),`${$d[ot]} (m/s)`,e.shown!=="rms"]}function z(){let{field:k}=t;if($t(c,k?t.error??"":t.error??"No result yet: the first shot that is measured appears here."),b.classList.toggle("without",!k),!k)return;let Q=P(k),lt=Uf(k,Q),ot=Fr(Q),K=new hr(0,qi(ot,Zd));n.frame(k),n.showVectors(k,Q,K,h.input.checked),n.showBodies(k,i.mask),s.show(K,e.shown==="rms"?"fluctuation (m/s)":"speed (m/s)");let ut=Fr(lt),ft=qi(ut,.995)*e.level/100;$t(f.shown,`${qt(ft)} 1/s`),n.showSurface(k,d.input.checked&&ft>0?A0(ut,k.n,ft):null),D(k,Q,lt,K),H(k,Q),W(k,ot),n.draw()}function D(k,Q,lt,ot){let K=k.n[e.axis];e.index=Math.min(K-1,e.index??Math.floor(K/2)),g.input.max=K-1,g.input.value=e.index,$t(g.shown,`${"xyz"[e.axis]} = ${qt(k.first[e.axis]+e.index*k.spacing,2)} mm`);let[ut,ft,_t]=O(k,Q,lt),mt=qi(ut.map(Math.abs),Zd),Bt=new hr(_t?-mt:0,mt,_t);e.along===e.axis&&(e.along=As[e.axis][0]),v.input.value=String(e.along);let[Kt,Ft]=As[e.axis],ce=e.along===Kt,le=k.n[ce?Ft:Kt];e.line=Math.min(le-1,e.line??Math.floor(le/2));let ne={along:ce?0:1,index:e.line};o.draw(k,ut,Q,{axis:e.axis,index:e.index,scale:Bt,longest:ot.high,line:ne}),r.show(Bt,ft);let Ne=bh(k,ut,e.axis,e.index),Ue=u.input.checked?Yd(Ne,Bt):null;n.showSlice(k,e.axis,e.index,Ue,Ne[0].length,Ne.length)}function H(k,Q){let[lt,ot]=As[e.axis],K=e.along===lt?ot:lt,ut=[],ft=[[],[],[]];for(let _t=0;_t<k.n[e.along];_t+=1){let mt=[0,0,0];[mt[e.axis],mt[e.along],mt[K]]=[e.index,_t,e.line];let Bt=mt[0]+k.n[0]*(mt[1]+k.n[1]*mt[2]);ut.push(k.first[e.along]+_t*k.spacing),ft.forEach((Kt,Ft)=>Kt.push(Q[3*Bt+Ft]===Q[3*Bt+Ft]?Q[3*Bt+Ft]:null))}A.show([ut,...ft])}function W(k,Q){let lt=k.status.reduce((ut,ft)=>ut+(ft===1),0),ot=Ff(k);l.valid.show(An(ot,1),ot<.7?"doubt":null);let K=Wh(k);l.replaced.show(An(lt/Math.max(1,K),1)),C.hidden=K===k.status.length,l.masked.show(K<k.status.length?String(k.status.length-K):"none"),l.speed.show(`${qt(qi(Q,Zd))} m/s`),l.uncertainty.show(`${qt(qi(k.uncertainty,.5),2)} m/s`),l.shots.show(String(t.running.shots)),S.forEach((ut,ft)=>{let _t=gl(k,ft),mt=Mm(_t,Math.min(48,Math.max(8,Math.round(1.5*Math.sqrt(_t.length)))));ut.show([mt.centres,mt.counts])});for(let[ut,ft]of[[M,bm(k)],[_,V(k)]])$t(ut,ft?.text??""),ft?.tone?ut.dataset.tone=ft.tone:delete ut.dataset.tone}function V(k){let Q=i.status?.configuration.window_mm;return Q?wm(k,Q):null}let ht=null;function J(){a.update(),i.mask!==ht&&(ht=i.mask,N())}return{element:b,update:J,show:()=>z()}}var nT="LFPIVPA1",iT=.99,P0={few:3,many:2},sT=3e3,rT=1;async function I0(i){return oT(await ir(`/api/v1/results/${i}/particles?format=binary`))}function oT(i){let t=new DataView(i),e=String.fromCharCode(...new Uint8Array(i,0,8));if(e!==nT)throw new Error(`particles of another version: ${e}`);let[n,s]=[16,20].map(u=>t.getUint32(u,!0)),r=t.getUint32(28,!0),o=t.getFloat64(32,!0)*.001/t.getFloat64(40,!0),a=new Float32Array(i,r+12*n,3*n),c=new Uint8Array(i,r+(36+4*s)*n,n),l=Float32Array.from({length:n},(u,f)=>o*Math.hypot(...a.subarray(3*f,3*f+3))),h=c.reduce((u,f)=>u+f,0),d=new hr(0,qi(l.map((u,f)=>c[f]?u:NaN),iT),!1,ym);return{count:n,at:new Float32Array(i,r,3*n),speed:l,valid:c,accepted:h,scale:d}}function L0(i,{count:t,at:e,speed:n,valid:s,scale:r},[o,a],c,l){let h=(t<sT?P0.few:P0.many)*l,d=(u,f)=>{let[p,y]=c(e[3*u+o],e[3*u+a]);i.fillRect(p-f/2,y-f/2,f,f)};i.fillStyle="#000000";for(let u=0;u<t;u+=1)s[u]&&d(u,h+2*rT*l);for(let u=0;u<t;u+=1)s[u]&&(i.fillStyle=`rgb(${r.rgb(n[u]).join(" ")})`,d(u,h))}var aT={xy:[0,1],xz:[0,2],yz:[1,2]},lT=700,cT=.7,D0="share of the voxels that are flow, as [volume.mask] says";function N0(i){let t={frame:"a",held:null},e=Yr(i,v=>{t.held=v,y()}),n=as("Frame",{a:"a",b:"b"},v=>{t.frame=v,y()}),s=Ns("Particles",!0,()=>m()),r=Jo(),o=Y("p",{class:"empty"}),a={size:Wt("Volume"),voxels:Wt("Voxels"),flow:Wt("Flow",{title:D0}),particles:Wt("Particles",{title:"from the statistics of the first measured pair's views"}),perWindow:Wt("Particles per window"),placed:Wt("Particles placed",{title:"seen in the images of both frames; valid: they agree with those about them, and are drawn"}),unexplained:Wt("Light unexplained",{title:"per camera; 0: everything is explained"}),agreement:Wt("Cameras agree",{title:"correlation of the cameras' light along the direction that both see"}),disparity:Wt("Cameras apart")},c=Y("p",{class:"hint legend"},Y("span",{class:"swatch","aria-hidden":"true"}),"Not flow: the deeper the tint, the more of the line of sight. There is light in it, but no vector is measured, and no particle is placed in a volume with a mask."),l=Object.entries(aT).map(([v,A])=>hT(v,A)),h=Y("div",{class:"view volume"},Y("div",{class:"controls"},e.element,n.element,s.element,o),Y("dl",{class:"readings"},...Object.values(a).map(v=>v.element)),c,Y("div",{class:"three"},...l.map(v=>v.element)),r.element);for(let v of[c,s.element,a.placed.element,r.element])v.hidden=!0;let d=null,u=null,f=!1,p=-1/0;async function y(){if(f||h.hidden||document.hidden||!i.status)return;let v=t.held??i.latestResult;if(v===null){$t(o,"No result yet.");return}f=!0,p=performance.now();try{let{configuration:A}=i.status,[S,C]=await Promise.allSettled([Promise.all(l.map(M=>qa(`/api/v1/results/${v}/projections/${t.frame}/${M.name}.png`))),A.place_particles?I0(v):null]);if(u=C.value??null,!S.value&&!u)throw S.reason;l.forEach((M,_)=>M.show(S.value?.[_].bitmap??null,A,i.mask)),m(),d=`${v} ${t.frame}`,$t(o,(S.reason??C.reason)?.message??"")}catch(A){$t(o,A instanceof mn?A.message:"the daemon does not answer")}finally{f=!1}}function m(){l.forEach(v=>v.particles(s.input.checked?u:null)),r.element.hidden=!(u&&s.input.checked),a.placed.show(u?`${Me(u.count)}, ${Me(u.accepted)} valid`:"–"),u&&r.show(u.scale,"speed of the particles (m/s)")}function g(){e.update();let{status:v}=i;if(!v)return;s.element.hidden=a.placed.element.hidden=!v.configuration.place_particles;let{voxels_xyz:A,voxel_mm:S}=v.configuration;a.size.show(`${A.map(R=>qt(R*S)).join(" × ")} mm`),a.voxels.show(`${A.join(" × ")} of ${qt(S)} mm`);let{mask:C}=v.configuration;a.flow.show(C?`${An(C.flow_share,1)} of the volume`:"all of it"),a.flow.element.title=[D0,...(C?.files??[]).map(({file:R,sha256:P})=>`${R}, SHA-256 ${P}`)].join(`
`),c.hidden=!i.mask,l.forEach(R=>R.mask(i.mask));let M=v.model_choice?.scene;a.particles.element.hidden=a.perWindow.element.hidden=!M;let _=A.reduce((R,P)=>R*P*S,1);a.particles.show(M?`${Me(Math.round(M.particles_per_mm3*_))}, ${qt(M.particles_per_mm3,2)} per mm³`:"–"),a.perWindow.show(qt(M?.particles_per_window,2));let b=v.model_fit;a.unexplained.show(b?b.cameras.map(R=>An(R.unexplained)).join(", "):"–"),a.agreement.show(qt(b?.camera_agreement,2)),a.disparity.show(b?.camera_disparity_mm?`${qt(b.camera_disparity_mm,2)} mm`:"–"),`${t.held??i.latestResult} ${t.frame}`!==d&&t.held===null&&performance.now()-p>lT&&y()}return{element:h,update:g,show(){y(),l.forEach(v=>v.draw())}}}function hT(i,[t,e]){let n="xyz"[3-t-e],s=Y("canvas",{class:"projection",role:"img","aria-label":`Largest light along ${n}`}),r=null,o=null,a=null,c=null,l=null;new ResizeObserver(()=>h()).observe(s);function h(){let{width:d,height:u,ratio:f}=Us(s),p=s.getContext("2d");if(p.setTransform(1,0,0,1,0,0),p.clearRect(0,0,d,u),!o)return;let y=[t,e].map(R=>o.voxels_xyz[R]*o.voxel_mm),m=[t,e].map(R=>o.centre_mm[R]),[g,v,A]=[46*f,38*f,10*f],S=Math.min((d-g-A)/y[0],(u-v-A)/y[1]),[C,M]=y.map(R=>R*S),[_,b]=[g+(d-g-A-C)/2,A+(u-v-A-M)/2];if(p.imageSmoothingEnabled=!1,p.fillStyle="#000000",p.fillRect(_,b,C,M),r&&p.drawImage(r,_,b,C,M),a&&(c??=uT(a,t,e),p.drawImage(c,_,b,C,M)),l){let R=(P,O)=>[_+(P-m[0]+y[0]/2)*S,b+M-(O-m[1]+y[1]/2)*S];p.save(),p.beginPath(),p.rect(_,b,C,M),p.clip(),L0(p,l,[t,e],R,f),p.restore()}let N=Fn("ink");p.strokeStyle=p.fillStyle=N,p.lineWidth=f,p.strokeRect(_,b,C,M),p.font=`${12*f}px system-ui, sans-serif`;for(let[R,P]of[[0,"x"],[1,"y"]])for(let O of dT(m[R]-y[R]/2,m[R]+y[R]/2)){let z=(O-m[R]+y[R]/2)*S;p.beginPath(),P==="x"?(p.moveTo(_+z,b+M),p.lineTo(_+z,b+M+5*f),p.textAlign="center",p.textBaseline="top",p.fillText(On(O),_+z,b+M+7*f)):(p.moveTo(_,b+M-z),p.lineTo(_-5*f,b+M-z),p.textAlign="right",p.textBaseline="middle",p.fillText(On(O),_-8*f,b+M-z)),p.stroke()}}return{name:i,element:en(`Along ${n}: ${"xyz"[t]} to the right, ${"xyz"[e]} upwards, in mm`,s),show(d,u,f){r?.close(),r=d,o=u,a!==f&&([a,c]=[f,null]),h()},particles(d){l=d,h()},mask(d){a!==d&&([a,c]=[d,null],h())},draw:h}}function uT(i,t,e){let[n,s]=[i.n[t],i.n[e]],r=Mf(i,t,e),o=new ImageData(n,s),a=Fn("mask"),c=[1,3,5].map(h=>parseInt(a.slice(h,h+2),16));for(let h=0;h<s;h+=1)for(let d=0;d<n;d+=1){let u=r[(s-1-h)*n+d];o.data.set([...c,Math.round(255*cT*u)],4*(h*n+d))}let l=document.createElement("canvas");return[l.width,l.height]=[n,s],l.getContext("2d").putImageData(o,0,0),l}function dT(i,t){let e=(t-i)/5,n=10**Math.floor(Math.log10(e)),s=[1,2,5,10].map(o=>o*n).find(o=>o>=e),r=[];for(let o=Math.ceil(i/s);o*s<=t+1e-9;o+=1)r.push(o*s);return r}var Xn=new $a,Po=new Ya(Xn),O0=new ja(Xn),B0=Lf(Xn,Po),Th={overview:["Overview",()=>gm(Xn)],cameras:["Cameras",()=>um(Xn)],volume:["Volume",()=>N0(Xn)],velocity:["Velocity",()=>C0(Xn,O0)],run:["Run",()=>vm(Xn,Po)]},wr={},Bi=null,U0=!0,k0=Object.entries(Th).map(([i,[t]])=>Y("a",{href:`#${i}`,"data-view":i},t)),z0=Y("main",{tabindex:"-1"});document.body.replaceChildren(Y("header",{},B0.element,Y("nav",{"aria-label":"Views"},...k0,Df()),Po.said),z0,Po.dialog);function V0(){let i=location.hash.slice(1);Bi=Object.hasOwn(Th,i)?i:"overview",wr[Bi]??=Th[Bi][1]();let{element:t}=wr[Bi];t.isConnected||z0.append(t);for(let[e,n]of Object.entries(wr))n.element.hidden=e!==Bi;k0.forEach(e=>Un(e,"aria-current",e.dataset.view===Bi?"page":null)),document.title=`lfpiv bench: ${Th[Bi][0]}`,wr[Bi].update(),wr[Bi].show()}function G0(){Un(document.documentElement,"data-stale",Xn.stale?"":null),Xn.stale&&!U0&&Po.doubt(),U0=Xn.stale,B0.update(),wr[Bi]?.update()}window.addEventListener("hashchange",V0);document.addEventListener("themechange",()=>wr[Bi].show());document.addEventListener("visibilitychange",()=>{document.hidden||(Xn.ask(),O0.fetchWanted())});Xn.watch(()=>{G0(),Xn.refusal?.status===401&&fT()});V0();G0();Xn.start();var F0=!1;function fT(){F0||(F0=!0,Po.askForToken(Xn.refusal.message))}
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
